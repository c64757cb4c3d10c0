#include "rt/programs/output_letters.h"

#include <algorithm>

#include "common/error.h"
#include "rt/path_coefficient.h"

namespace infra {
namespace {

/// A shadow ray that was stopped on its way brings nothing.
bool missed_its_source(const CompiledScene& scene, const Interaction& at) {
    const int source = at.ray->aimed_source;
    return source >= 0 && scene.source(source).surface != at.surface && at.radiance.mean() <= same_place;
}

Vec3 normal_as_defined(const Interaction& at) {
    if (!at.hit()) return Vec3{0};
    return at.flipped ? -at.normal : at.normal;
}

using Scene = CompiledScene;
using Hit = Interaction;
using Out = ValueWriter;

constexpr const char* nothing_met = "*";

constexpr OutputLetter letters[] = {
    {'o', "origin", 3, false, [](const Scene&, const Hit& at, Out& out) { out.vector(at.ray->origin); }},
    {'d', "direction", 3, false,
     [](const Scene&, const Hit& at, Out& out) { out.vector(at.ray->direction); }},
    {'r', "reflect_contrib", per_value, true,
     [](const Scene&, const Hit& at, Out& out) { out.radiance(at.mirrored); }},
    {'R', "reflect_length", 1, true,
     [](const Scene&, const Hit& at, Out& out) { out.real(at.mirrored_distance); }},
    {'x', "unreflect_contrib", per_value, true,
     [](const Scene&, const Hit& at, Out& out) {
         Spectrum rest = at.radiance;
         out.radiance(rest -= at.mirrored);
     }},
    {'X', "unreflect_length", 1, true,
     [](const Scene&, const Hit& at, Out& out) { out.real(at.direct_distance); }},
    {'v', "value", per_value, true, [](const Scene&, const Hit& at, Out& out) { out.radiance(at.radiance); }},
    {'V', "contribution", per_value, true,
     [](const Scene&, const Hit& at, Out& out) { out.radiance(path_coefficient(at) *= at.radiance); }},
    {'l', "length", 1, true, [](const Scene&, const Hit& at, Out& out) { out.real(at.apparent_distance()); }},
    {'L', "first_length", 1, false, [](const Scene&, const Hit& at, Out& out) { out.real(at.distance); }},
    // Only meshes have local coordinates.
    {'c', "local_coordinates", 2, false,
     [](const Scene&, const Hit& at, Out& out) {
         out.real(at.local_uv[0]);
         out.real(at.local_uv[1]);
     }},
    {'p', "point", 3, false, [](const Scene&, const Hit& at, Out& out) { out.vector(at.point); }},
    {'n', "normal", 3, true,
     [](const Scene&, const Hit& at, Out& out) { out.vector(at.hit() ? at.perturbed_normal() : Vec3{0}); }},
    {'N', "unperturbed_normal", 3, false,
     [](const Scene&, const Hit& at, Out& out) { out.vector(normal_as_defined(at)); }},
    {'s', "surface", 1, false,
     [](const Scene& scene, const Hit& at, Out& out) {
         out.name(at.hit() ? scene.surface_name(at.surface) : nothing_met);
     }},
    {'w', "weight", 1, false, [](const Scene&, const Hit& at, Out& out) { out.real(at.ray->weight); }},
    {'W', "coefficient", per_value, true,
     [](const Scene& scene, const Hit& at, Out& out) {
         const bool counts = !at.counted_elsewhere && !missed_its_source(scene, at);
         out.share(counts ? path_coefficient(at) : Spectrum(at.channels()));
     }},
    {'m', "modifier", 1, false,
     [](const Scene& scene, const Hit& at, Out& out) {
         out.name(at.hit() ? scene.modifier_name(at.surface) : nothing_met);
     }},
    {'M', "material", 1, false,
     [](const Scene& scene, const Hit& at, Out& out) {
         out.name(at.hit() ? scene.material_name(at.surface) : nothing_met);
     }},
    {'~', "tilde", 0, false, [](const Scene&, const Hit&, Out& out) { out.name("~"); }},
};

bool starts_tree(char letter) { return letter == 't' || letter == 'T'; }

const OutputLetter* find_letter(char letter) {
    for (const OutputLetter& candidate : letters)
        if (candidate.letter == letter) return &candidate;
    return nullptr;
}

}  // namespace

std::span<const OutputLetter> output_letters() { return letters; }

bool OutputSpec::needs_radiance() const {
    const auto needs = [](const OutputLetter* letter) { return letter->needs_radiance; };
    return has_tree() || std::any_of(primary.begin(), primary.end(), needs);
}

bool OutputSpec::has_any(std::string_view wanted) const {
    const auto found = [wanted](const OutputLetter* letter) {
        return wanted.find(letter->letter) != wanted.npos;
    };
    return std::any_of(primary.begin(), primary.end(), found);
}

int OutputSpec::components(int numbers) const {
    if (has_tree()) return 0;
    int sum = 0;
    for (const OutputLetter* letter : primary)
        sum += letter->components == per_value ? numbers : letter->components;
    return sum;
}

OutputSpec parse_output(std::string_view text) {
    if (text.empty())
        throw Error("empty output specification", "-ov writes radiance; -help lists the letters");
    OutputSpec spec;
    bool in_tree = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (starts_tree(text[i])) {
            if (text[i] == 'T') spec.trace_sources = true;
            // A trace that nothing follows writes nothing.
            in_tree = i + 1 < text.size();
            continue;
        }
        const OutputLetter* letter = find_letter(text[i]);
        if (!letter)
            throw Error(std::string("unrecognized output option '") + text[i] + "'",
                        "-help lists the letters");
        (in_tree ? spec.tree : spec.primary).push_back(letter);
    }
    return spec;
}

std::string output_names(std::string_view text) {
    std::string names;
    for (const char c : text) {
        if (starts_tree(c)) names += " trace";
        if (const OutputLetter* letter = find_letter(c)) names += std::string(" ") + letter->name;
    }
    return names;
}

}  // namespace infra
