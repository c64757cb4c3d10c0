#include "rt/compile/modifier_table.h"

namespace infra {
namespace {

using enum PrimitiveType;

constexpr ModifierRow rows[] = {
    {plastic, make_plastic},
    {metal, make_metal},
    {trans, make_trans},
    {glass, make_glass},
    {light, make_light},
    {glow, make_glow},
    {illum, make_illum},
    {spotlight, make_spotlight},
    {emissive, make_emissive},
    {thermal, make_thermal},
    {nrlbrdf, make_nrlbrdf},
    {brightfunc, make_brightfunc},
    {colorfunc, make_colorfunc},
    {brightdata, make_brightdata},
    {colordata, make_colordata},
    {colorpict, make_colorpict},
    {spectrum, make_spectrum},
    {specfile, make_specfile},
    {specfunc, make_specfunc},
    {specdata, make_specdata},
    {specpict, make_specpict},
    {texfunc, make_texfunc},
    {texdata, make_texdata},
    {mixfunc, make_mixfunc},
    {mixdata, make_mixdata},
    {mixpict, make_mixpict},
    {dielectric, make_dielectric},
    {interface, make_interface},
    {mist, make_mist},
    {antimatter, make_antimatter},
    {plasfunc, make_plasfunc},
    {metfunc, make_metfunc},
    {transfunc, make_transfunc},
    {plasdata, make_plasdata},
    {metdata, make_metdata},
    {transdata, make_transdata},
    {BRTDfunc, make_brtdfunc},
    {mirror, make_mirror},
    {prism1, make_prism1},
    {prism2, make_prism2},
    {plastic2, make_plastic2},
    {metal2, make_metal2},
    {trans2, make_trans2},
    {ashik2, make_ashik2},
    {brighttext, make_brighttext},
    {colortext, make_colortext},
    {mixtext, make_mixtext},
    {BSDF, make_bsdf},
    {aBSDF, make_absdf},
    {WGMDfunc, make_wgmdfunc},
};

}  // namespace

std::span<const ModifierRow> modifier_table() { return rows; }

const ModifierRow* find_modifier_row(PrimitiveType type) {
    for (const ModifierRow& row : rows)
        if (row.type == type) return &row;
    return nullptr;
}

std::vector<std::string_view> referenced_modifiers(const Scene& scene, PrimitiveId id) {
    const auto strings = scene.strings(id);
    std::size_t count = 0, step = 1;
    switch (scene.type(id)) {
        case alias:
        case illum:
        case mirror:
        case emissive:
        case thermal:
        case antimatter:  // of the others it only needs to know which they are
            count = 1;
            break;
        case mixfunc:
        case mixdata:
        case mixpict:
        case mixtext:
            count = 2;
            break;
        case WGMDfunc:
            count = 9;
            step = 4;
            break;
        default:
            break;
    }
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < count && i < strings.size(); i += step)
        if (strings[i] != "void" && strings[i] != "inherit") names.push_back(strings[i]);
    return names;
}

Spectrum ModifierContext::color(std::size_t first) const {
    const auto numbers = reals();
    return channels.from_rgb(numbers[first], numbers[first + 1], numbers[first + 2]);
}

const Modifier* ModifierContext::modifier_named(std::string_view modifier) const {
    if (modifier == "void") return nullptr;
    const PrimitiveId found = scene.find_modifier_before(modifier, id);
    if (found == void_primitive) {
        const std::string near = nearest_name(modifier, scene.modifier_names());
        throw error("undefined modifier \"" + std::string(modifier) + "\"",
                    near.empty() ? "" : "did you mean \"" + near + "\"?");
    }
    return made[static_cast<std::size_t>(found)];
}

}  // namespace infra
