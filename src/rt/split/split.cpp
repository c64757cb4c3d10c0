#include "rt/split/split.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "common/error.h"
#include "rt/compile/compiled_scene.h"

namespace infra {
namespace {

constexpr double widest_sun = 5 * std::numbers::pi / 180;  // radius

/// Whether a surface wears a modifier of this name, itself or behind others.
bool wears(const CompiledScene& scene, int surface, std::string_view modifier) {
    if (scene.modifier_name(surface) == modifier) return true;
    for (const Modifier* m = scene.finish(surface).modifier; m; m = m->next())
        if (m->name() == modifier) return true;
    return false;
}

Origin usual_origin(const CompiledScene& scene, int surface) {
    const int number = scene.surface(surface).source;
    if (number < 0 || !scene.source(number).distant()) return Origin::ship;
    const LightSource& source = scene.source(number);
    if (source.least_cosine > std::cos(widest_sun)) return Origin::sun;
    return source.center.z < 0 ? Origin::sea : Origin::sky;
}

}  // namespace

Split::Split(const CompiledScene& scene, const SplitSettings& settings)
    : channels_(scene.channels()), bounces_(settings.bounces) {
    std::vector<char> used(settings.modifiers.size());
    const int count = scene.surface_count();
    origins_.reserve(static_cast<std::size_t>(count));
    for (int surface = 0; surface < count; ++surface) {
        Origin origin = usual_origin(scene, surface);
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!wears(scene, surface, settings.modifiers[i].second)) continue;
            origin = settings.modifiers[i].first;
            used[i] = 1;
        }
        origins_.push_back(static_cast<std::uint8_t>(origin));
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i])
            throw Error("no surface has the modifier \"" + settings.modifiers[i].second +
                        "\" that -splitm names");
}

void Split::arrive(int surface, Spectrum& radiance) const {
    if (surface < 0) return;
    const int bands = channels_.bands();
    const int from = static_cast<int>(origin(surface));
    Spectrum result(radiance.channels());
    for (int b = 0; b < bands; ++b) {
        const auto add = [&](int component, float value) {
            const int c = component * bands + b;
            result.set(c, result[c] + value);
        };
        for (int own = emitted; own < first_reflected; ++own)
            add(reflected(from, 1), radiance[own * bands + b]);
        for (int before = 0; before < origin_count; ++before)
            for (int bounce = 1; bounce <= bounces_; ++bounce)
                add(reflected(from, std::min(bounce + 1, bounces_)),
                    radiance[reflected(before, bounce) * bands + b]);
    }
    radiance = result;
}

void Split::into_path(Spectrum& radiance) const {
    const int bands = channels_.bands();
    Spectrum result(radiance.channels());
    for (int c = 0; c < radiance.channels(); ++c) {
        const int target = path * bands + channels_.band_of(c);
        result.set(target, result[target] + radiance[c]);
    }
    radiance = result;
}

std::vector<std::string> component_names(const SplitSettings& settings) {
    std::vector<std::string> names = {"emitted", "path", "assumed"};
    for (int origin = 0; origin < origin_count; ++origin)
        for (int bounce = 1; bounce <= settings.bounces; ++bounce) {
            std::string name = "reflected_" + std::string(origin_name(static_cast<Origin>(origin)));
            if (settings.bounces > 1) name += std::to_string(bounce);
            names.push_back(std::move(name));
        }
    return names;
}

}  // namespace infra
