// mist: the boundary of a volume of haze.
//
//     mod mist id
//     N src1 src2 .. srcN
//     0
//     0 | 3 | 6 | 7 ext_r ext_g ext_b [albedo_r albedo_g albedo_b [g]]
//
// The extinction, per scene unit, is added to what is there; patterns on `mod` multiply it. The albedo is the
// share of it that is scattering, g the eccentricity of Henyey and Greenstein's function (-1..1); they
// replace -ma and -mg. Sources are named by their surfaces, and only those named are scattered inside;
// "mirror>lamp" is the image of lamp in mirror. Volumes may overlap. An eye inside is noticed where the mist
// names sources; that in one without shows from where a ray enters. source: RADIANCE reference manual,
// "Mist".
#include "rt/volume/mist.h"

#include <algorithm>

#include "rt/tracer.h"

namespace infra {
namespace {

/// Whether a source goes by this name, "relay>...>source".
bool answers_to(const CompiledScene& scene, const LightSource* source, std::string_view name) {
    for (std::size_t end; (end = name.find('>')) != name.npos; name.remove_prefix(end + 1)) {
        if (!source->is_virtual() || scene.surface_name(source->surface) != name.substr(0, end)) return false;
        source = &scene.source(source->parent);
    }
    return !source->is_virtual() && scene.surface_name(source->surface) == name;
}

/// The last source of that name, -1 for none.
int source_named(const CompiledScene& scene, std::string_view name) {
    for (int i = static_cast<int>(scene.sources().size()); i-- > 0;)
        if (answers_to(scene, &scene.source(i), name)) return i;
    return -1;
}

}  // namespace

Mist::Mist(ModifierContext& context)
    : Modifier(context.name(), context.next),
      traits_{.name = context.name(), .transparent = true},
      number_(context.first_number + context.id),
      source_names_(context.strings().begin(), context.strings().end()),
      added_(context.channels.count()),
      has_extinction_(context.reals().size() >= 3),
      has_albedo_(context.reals().size() >= 6),
      has_eccentricity_(context.reals().size() >= 7) {
    if (source_names_.size() > ScatteredSources::capacity)
        throw context.error("more than 32 light sources in one mist");
    if (has_extinction_) added_.extinction = context.color(0);
    if (has_albedo_) added_.albedo = context.color(3);
    if (has_eccentricity_) added_.eccentricity = context.reals()[6];
}

void Mist::find_sources(const CompiledScene& scene, std::vector<std::string>& warnings) {
    const auto warn = [&](const char* what, std::string_view name) {
        const std::string text = std::string(what) + " \"" + std::string(name) + "\"";
        warnings.push_back(scene.error(number_, text, "mist names surfaces that are light sources").what());
    };
    for (const std::string_view name : source_names_) {
        const int source = source_named(scene, name);
        if (source < 0)
            warn("unknown source", name);
        else if (added_.sources.contains(source))
            warn("duplicate source", name);
        else
            added_.sources.add(source);
    }
}

bool Mist::shade(Tracer& tracer, Interaction& at) const {
    Spectrum extinction = added_.extinction;
    if (has_extinction_ && next()) {
        tracer.apply_patterns(next(), at);
        extinction *= at.pattern;
    }
    const Medium& open = tracer.scene().surroundings();
    Medium beyond = at.medium ? *at.medium : open;
    if (at.cosine > 0) {
        add_to(beyond, extinction);
    } else if (is_known_to(beyond)) {
        take_from(beyond, extinction, open);
    } else {  // the ray started inside
        Medium here = beyond;
        add_to(here, extinction);
        at.has_travelled_in(here);
        take_from(beyond, Spectrum(at.channels()), open);
    }
    tracer.pass_into(beyond.matters() ? &beyond : nullptr, at);
    return true;
}

void Mist::add_to(Medium& medium, const Spectrum& extinction) const {
    medium.extinction += extinction;
    if (has_albedo_) medium.albedo = added_.albedo;
    if (has_eccentricity_) medium.eccentricity = added_.eccentricity;
    medium.sources.add(added_.sources);
}

// What is left is never thinner than the surroundings.
void Mist::take_from(Medium& medium, const Spectrum& extinction, const Medium& open) const {
    for (int c = 0; c < extinction.channels(); ++c)
        medium.extinction.set(c, std::max(medium.extinction[c] - extinction[c], open.extinction[c]));
    if (has_albedo_) medium.albedo = open.albedo;
    if (has_eccentricity_) medium.eccentricity = open.eccentricity;
    for (const int source : added_.sources) medium.sources.remove(source);
}

/// Whether a ray with this medium at its start knows that it is inside, as far as its sources tell.
bool Mist::is_known_to(const Medium& medium) const {
    return std::all_of(added_.sources.begin(), added_.sources.end(),
                       [&](int source) { return medium.sources.contains(source); });
}

std::unique_ptr<Modifier> make_mist(ModifierContext& context) { return std::make_unique<Mist>(context); }

}  // namespace infra
