// The one list of modifiers that can be rendered: a row a type. What a type's arguments are stands in
// scene/primitive_types; a type without a row is refused by name when a renderer loads it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cal/library.h"
#include "common/spectra/channels.h"
#include "rt/modifier.h"
#include "rt/settings.h"
#include "scene/scene.h"

namespace infra {

struct DataCache;
struct TableCache;

/// What a factory may ask while it makes a modifier.
class ModifierContext {
  public:
    const Scene& scene;
    PrimitiveId id;  ///< whose arguments to read; their number has been checked
    PrimitiveId
        first_number;      ///< added to one of `scene`: its number among those of the whole scene (ScenePart)
    const Modifier* next;  ///< what modifies it
    const Channels& channels;
    const RenderSettings& settings;
    cal::Library& functions;
    TableCache& tables;
    DataCache& data;
    const std::vector<const Modifier*>& made;  ///< by primitive, as far as they are used
    std::vector<std::string>& warnings;

    std::string_view name() const { return scene.name(id); }
    std::span<const double> reals() const { return scene.reals(id); }
    std::span<const std::string_view> strings() const { return scene.strings(id); }
    /// Red, green and blue arguments from `first` on, given to all channels.
    Spectrum color(std::size_t first) const;
    /// The same as a radiance that a surface sends out by itself: into the first component of a rendering.
    Spectrum emission(std::size_t first) const { return channels.in_component(0, color(first)); }
    /// The modifier that a string argument names: nullptr for void.
    const Modifier* modifier_named(std::string_view name) const;
    Error error(std::string_view message, std::string_view hint = {}) const {
        return scene.error(id, message, hint);
    }
};

struct ModifierRow {
    PrimitiveType type;
    std::unique_ptr<Modifier> (*make)(ModifierContext&);
};

std::span<const ModifierRow> modifier_table();
const ModifierRow* find_modifier_row(PrimitiveType type);

/// Names of modifiers in a primitive's string arguments (mixtures, alias, illum, emissive).
std::vector<std::string_view> referenced_modifiers(const Scene& scene, PrimitiveId id);

// One factory a file below.
std::unique_ptr<Modifier> make_plastic(ModifierContext&);
std::unique_ptr<Modifier> make_metal(ModifierContext&);
std::unique_ptr<Modifier> make_trans(ModifierContext&);
std::unique_ptr<Modifier> make_glass(ModifierContext&);
std::unique_ptr<Modifier> make_light(ModifierContext&);
std::unique_ptr<Modifier> make_glow(ModifierContext&);
std::unique_ptr<Modifier> make_illum(ModifierContext&);
std::unique_ptr<Modifier> make_spotlight(ModifierContext&);
std::unique_ptr<Modifier> make_emissive(ModifierContext&);
std::unique_ptr<Modifier> make_thermal(ModifierContext&);
std::unique_ptr<Modifier> make_nrlbrdf(ModifierContext&);
std::unique_ptr<Modifier> make_brightfunc(ModifierContext&);
std::unique_ptr<Modifier> make_colorfunc(ModifierContext&);
std::unique_ptr<Modifier> make_brightdata(ModifierContext&);
std::unique_ptr<Modifier> make_colordata(ModifierContext&);
std::unique_ptr<Modifier> make_colorpict(ModifierContext&);
std::unique_ptr<Modifier> make_spectrum(ModifierContext&);
std::unique_ptr<Modifier> make_specfile(ModifierContext&);
std::unique_ptr<Modifier> make_specfunc(ModifierContext&);
std::unique_ptr<Modifier> make_specdata(ModifierContext&);
std::unique_ptr<Modifier> make_specpict(ModifierContext&);
std::unique_ptr<Modifier> make_texfunc(ModifierContext&);
std::unique_ptr<Modifier> make_texdata(ModifierContext&);
std::unique_ptr<Modifier> make_mixfunc(ModifierContext&);
std::unique_ptr<Modifier> make_mixdata(ModifierContext&);
std::unique_ptr<Modifier> make_mixpict(ModifierContext&);
std::unique_ptr<Modifier> make_plastic2(ModifierContext&);
std::unique_ptr<Modifier> make_metal2(ModifierContext&);
std::unique_ptr<Modifier> make_trans2(ModifierContext&);
std::unique_ptr<Modifier> make_ashik2(ModifierContext&);
std::unique_ptr<Modifier> make_mirror(ModifierContext&);
std::unique_ptr<Modifier> make_prism1(ModifierContext&);
std::unique_ptr<Modifier> make_prism2(ModifierContext&);
std::unique_ptr<Modifier> make_dielectric(ModifierContext&);
std::unique_ptr<Modifier> make_interface(ModifierContext&);
std::unique_ptr<Modifier> make_mist(ModifierContext&);
std::unique_ptr<Modifier> make_antimatter(ModifierContext&);
std::unique_ptr<Modifier> make_plasfunc(ModifierContext&);
std::unique_ptr<Modifier> make_metfunc(ModifierContext&);
std::unique_ptr<Modifier> make_transfunc(ModifierContext&);
std::unique_ptr<Modifier> make_plasdata(ModifierContext&);
std::unique_ptr<Modifier> make_metdata(ModifierContext&);
std::unique_ptr<Modifier> make_transdata(ModifierContext&);
std::unique_ptr<Modifier> make_brtdfunc(ModifierContext&);
std::unique_ptr<Modifier> make_wgmdfunc(ModifierContext&);
std::unique_ptr<Modifier> make_bsdf(ModifierContext&);
std::unique_ptr<Modifier> make_absdf(ModifierContext&);
std::unique_ptr<Modifier> make_brighttext(ModifierContext&);
std::unique_ptr<Modifier> make_colortext(ModifierContext&);
std::unique_ptr<Modifier> make_mixtext(ModifierContext&);

}  // namespace infra
