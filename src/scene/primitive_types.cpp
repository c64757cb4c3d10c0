#include "scene/primitive_types.h"

#include <unordered_map>
#include <vector>

#include "common/error.h"

namespace infra {
namespace {

using enum PrimitiveKind;

constexpr CountRule exactly(int n) { return {n, n}; }
constexpr CountRule either(int a, int b) { return {a, b, b - a}; }
constexpr CountRule at_least(int n) { return {n, CountRule::any_number}; }
constexpr CountRule any = at_least(0);
constexpr CountRule none = exactly(0);
constexpr CountRule triples_up_to(int n) { return {0, n, 3}; }
constexpr CountRule corners = {9, CountRule::any_number, 3};

constexpr TransformRule append = TransformRule::append;
constexpr TransformRule numbers = TransformRule::numbers;

// Meanings shared by several rows.
constexpr std::string_view sphere_args = "xcent ycent zcent radius";
constexpr std::string_view cone_args = "x0 y0 z0 x1 y1 z1 r0 r1";
constexpr std::string_view cylinder_args = "x0 y0 z0 x1 y1 z1 radius";
constexpr std::string_view rgb = "red green blue";
constexpr std::string_view normal_args = "red green blue specularity roughness";
constexpr std::string_view aniso_names = "ux uy uz funcfile transform...";
constexpr std::string_view aniso_args = "red green blue specularity urough vrough";
constexpr std::string_view parameters = "A1 A2...";
constexpr std::string_view brdf_args = "red green blue specularity A5...";
constexpr std::string_view btdf_args = "red green blue rspec trans tspec A7...";
constexpr std::string_view data_names = "func datafile funcfile x1 x2... transform...";
constexpr std::string_view sides_args = "rfdif gfdif bfdif rbdif gbdif bbdif rtdif gtdif btdif";
constexpr std::string_view sides_more_args = "rfdif gfdif bfdif rbdif gbdif bbdif rtdif gtdif btdif A10...";
constexpr std::string_view text_names = "fontfile textfile, or fontfile . word...";

// clang-format off
constexpr PrimitiveInfo table[] = {
    // type and its name                     kind      strings       reals          meaning of strings, of reals, transform
    {PrimitiveType::polygon, "polygon",       surface,  none,         corners,       "", "x1 y1 z1 x2 y2 z2 x3 y3 z3...", numbers},
    {PrimitiveType::cone, "cone",             surface,  none,         exactly(8),    "", cone_args, numbers},
    {PrimitiveType::sphere, "sphere",         surface,  none,         exactly(4),    "", sphere_args, numbers},
    {PrimitiveType::texfunc, "texfunc",       texture,  at_least(4),  any,           "xpert ypert zpert funcfile transform...", parameters, append},
    {PrimitiveType::ring, "ring",             surface,  none,         exactly(8),    "", "xcent ycent zcent xdir ydir zdir r0 r1", numbers},
    {PrimitiveType::cylinder, "cylinder",     surface,  none,         exactly(7),    "", cylinder_args, numbers},
    {PrimitiveType::instance, "instance",     volume,   at_least(1),  none,          "octree transform...", "", append},
    {PrimitiveType::cup, "cup",               surface,  none,         exactly(8),    "", cone_args, numbers},
    {PrimitiveType::bubble, "bubble",         surface,  none,         exactly(4),    "", sphere_args, numbers},
    {PrimitiveType::tube, "tube",             surface,  none,         exactly(7),    "", cylinder_args, numbers},
    {PrimitiveType::mesh, "mesh",             volume,   at_least(1),  none,          "meshfile transform...", "", append},
    {PrimitiveType::alias, "alias",           alias,    either(0, 1), none,          "target", ""},
    {PrimitiveType::plastic, "plastic",       material, none,         exactly(5),    "", normal_args},
    {PrimitiveType::metal, "metal",           material, none,         exactly(5),    "", normal_args},
    {PrimitiveType::glass, "glass",           material, none,         either(3, 4),  "", "rtn gtn btn [n]"},
    {PrimitiveType::trans, "trans",           material, none,         exactly(7),    "", "red green blue specularity roughness trans tspec"},
    {PrimitiveType::dielectric, "dielectric", material, none,         exactly(5),    "", "rtn gtn btn n hc", numbers},
    {PrimitiveType::plastic2, "plastic2",     material, at_least(4),  exactly(6),    aniso_names, aniso_args, append},
    {PrimitiveType::metal2, "metal2",         material, at_least(4),  exactly(6),    aniso_names, aniso_args, append},
    {PrimitiveType::trans2, "trans2",         material, at_least(4),  exactly(8),    aniso_names, "red green blue specularity urough vrough trans tspec", append},
    {PrimitiveType::interface, "interface",   material, none,         exactly(8),    "", "rtn1 gtn1 btn1 n1 rtn2 gtn2 btn2 n2", numbers},
    {PrimitiveType::plasfunc, "plasfunc",     material, at_least(2),  at_least(4),   "refl funcfile transform...", brdf_args, append},
    {PrimitiveType::metfunc, "metfunc",       material, at_least(2),  at_least(4),   "refl funcfile transform...", brdf_args, append},
    {PrimitiveType::brightfunc, "brightfunc", pattern,  at_least(2),  any,           "refl funcfile transform...", parameters, append},
    {PrimitiveType::brightdata, "brightdata", pattern,  at_least(4),  any,           data_names, parameters, append},
    {PrimitiveType::brighttext, "brighttext", pattern,  at_least(2),  at_least(11),  text_names, "Ox Oy Oz Rx Ry Rz Dx Dy Dz foreground background [spacing]", numbers},
    {PrimitiveType::colorpict, "colorpict",   pattern,  at_least(7),  any,           "rfunc gfunc bfunc pictfile funcfile u v transform...", parameters, append},
    {PrimitiveType::glow, "glow",             material, none,         exactly(4),    "", "red green blue maxrad", numbers},
    {PrimitiveType::source, "source",         surface,  none,         exactly(4),    "", "xdir ydir zdir angle", numbers},
    {PrimitiveType::light, "light",           material, none,         exactly(3),    "", rgb},
    {PrimitiveType::illum, "illum",           material, either(0, 1), exactly(3),    "[material]", rgb},
    {PrimitiveType::spotlight, "spotlight",   material, none,         exactly(7),    "", "red green blue angle xdir ydir zdir", numbers},
    {PrimitiveType::mist, "mist",             material, any,          {0, 6, 3, 7},  "source...", "[rext gext bext [ralb galb balb [g]]]", numbers},
    {PrimitiveType::mirror, "mirror",         material, either(0, 1), exactly(3),    "[material]", rgb},
    {PrimitiveType::transfunc, "transfunc",   material, at_least(2),  at_least(6),   "brtd funcfile transform...", btdf_args, append},
    {PrimitiveType::BRTDfunc, "BRTDfunc",     material, at_least(10), at_least(9),   "rrefl grefl brefl rtrns gtrns btrns rbrtd gbrtd bbrtd funcfile transform...", sides_more_args, append},
    {PrimitiveType::BSDF, "BSDF",             material, at_least(6),  triples_up_to(9), "thick BSDFfile ux uy uz funcfile transform...", sides_args, append},
    {PrimitiveType::aBSDF, "aBSDF",           material, at_least(5),  triples_up_to(9), "BSDFfile ux uy uz funcfile transform...", sides_args, append},
    {PrimitiveType::WGMDfunc, "WGMDfunc",     material, at_least(13), at_least(9),   "rs_mod rs rs_urough rs_vrough ts_mod ts ts_urough ts_vrough td_mod ux uy uz funcfile transform...", sides_more_args, append},
    {PrimitiveType::plasdata, "plasdata",     material, at_least(4),  at_least(4),   data_names, brdf_args, append},
    {PrimitiveType::metdata, "metdata",       material, at_least(4),  at_least(4),   data_names, brdf_args, append},
    {PrimitiveType::transdata, "transdata",   material, at_least(4),  at_least(6),   data_names, btdf_args, append},
    {PrimitiveType::colorfunc, "colorfunc",   pattern,  at_least(4),  any,           "red green blue funcfile transform...", parameters, append},
    {PrimitiveType::antimatter, "antimatter", material, at_least(1),  none,          "mod1 mod2...", ""},
    {PrimitiveType::colordata, "colordata",   pattern,  at_least(8),  any,           "rfunc gfunc bfunc rdatafile gdatafile bdatafile funcfile x1 x2... transform...", parameters, append},
    {PrimitiveType::colortext, "colortext",   pattern,  at_least(2),  at_least(15),  text_names, "Ox Oy Oz Rx Ry Rz Dx Dy Dz rfore gfore bfore rback gback bback [spacing]", numbers},
    {PrimitiveType::texdata, "texdata",       texture,  at_least(8),  any,           "xfunc yfunc zfunc xdfname ydfname zdfname funcfile x0 x1... transform...", parameters, append},
    {PrimitiveType::mixfunc, "mixfunc",       mixture,  at_least(4),  any,           "foreground background vname funcfile transform...", parameters, append},
    {PrimitiveType::mixdata, "mixdata",       mixture,  at_least(6),  any,           "foreground background func datafile funcfile x1 x2... transform...", parameters, append},
    {PrimitiveType::mixtext, "mixtext",       mixture,  at_least(4),  at_least(9),   "foreground background fontfile textfile, or foreground background fontfile . word...", "Ox Oy Oz Rx Ry Rz Dx Dy Dz [spacing]", numbers},
    {PrimitiveType::mixpict, "mixpict",       mixture,  at_least(7),  any,           "foreground background func pictfile funcfile u v transform...", parameters, append},
    {PrimitiveType::prism1, "prism1",         material, at_least(5),  any,           "coef dx dy dz funcfile transform...", parameters, append},
    {PrimitiveType::prism2, "prism2",         material, at_least(9),  any,           "coef1 dx1 dy1 dz1 coef2 dx2 dy2 dz2 funcfile transform...", parameters, append},
    {PrimitiveType::ashik2, "ashik2",         material, at_least(4),  exactly(8),    aniso_names, "dred dgrn dblu sred sgrn sblu u-power v-power", append},
    {PrimitiveType::spectrum, "spectrum",     pattern,  none,         at_least(5),   "", "nmA nmB s1 s2 s3..."},
    {PrimitiveType::specfile, "specfile",     pattern,  exactly(1),   none,          "datafile", ""},
    {PrimitiveType::specfunc, "specfunc",     pattern,  at_least(2),  at_least(2),   "sfunc funcfile transform...", "nmA nmB A3...", append},
    {PrimitiveType::specdata, "specdata",     pattern,  at_least(4),  any,           data_names, parameters, append},
    {PrimitiveType::specpict, "specpict",     pattern,  at_least(5),  any,           "func specfile funcfile u v transform...", parameters, append},
    {PrimitiveType::emissive, "emissive",     material, either(0, 1), either(3, 4),  "[material]", "Lr Lg Lb [maxrad]", numbers},
    {PrimitiveType::nrlbrdf, "nrlbrdf",       material, at_least(1),  either(5, 8),  "brdffile...", "red green blue nsamp alpha [Er Eg Eb]"},
    {PrimitiveType::thermal, "thermal",       material, either(0, 1), either(3, 4),  "[material]", "T lmin lmax [emissivity]"},
};
// clang-format on

static_assert(std::size(table) == primitive_type_count);

constexpr bool rows_stand_in_order() {
    for (std::size_t i = 0; i < std::size(table); ++i)
        if (static_cast<std::size_t>(table[i].type) != i) return false;
    return true;
}
static_assert(rows_stand_in_order());

}  // namespace

std::string CountRule::text() const {
    if (most == any_number) {
        const std::string first = std::to_string(least);
        if (step == 1) return "at least " + first;
        return first + ", " + std::to_string(least + step) + ", " + std::to_string(least + 2 * step) + "...";
    }
    std::vector<int> counts;
    for (int n = least; n <= most; n += step) counts.push_back(n);
    if (also >= 0) counts.push_back(also);
    std::string words;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (i > 0) words += i + 1 == counts.size() ? " or " : ", ";
        words += std::to_string(counts[i]);
    }
    return words;
}

std::string wrong_counts(const PrimitiveInfo& row, std::size_t strings, std::size_t reals) {
    const auto wrong = [](std::size_t count, const char* sort, const CountRule& rule) {
        std::string text = std::to_string(count) + " " + sort + (count == 1 ? " argument" : " arguments");
        return text + " where " + rule.text() +
               (rule.least == 1 && rule.most == 1 ? " is needed" : " are needed");
    };
    if (!row.strings.allows(strings)) return wrong(strings, "string", row.strings);
    if (!row.reals.allows(reals)) return wrong(reals, "real", row.reals);
    return "";
}

std::string argument_summary(const PrimitiveInfo& row) {
    std::string text(row.string_meaning);
    if (!text.empty() && !row.real_meaning.empty()) text += "; ";
    return text.append(row.real_meaning);
}

std::span<const PrimitiveInfo> primitive_types() { return table; }

const PrimitiveInfo* const detail::primitive_table = table;

std::optional<PrimitiveType> find_primitive_type(std::string_view name) {
    static const auto by_name = [] {
        std::unordered_map<std::string_view, PrimitiveType> map;
        for (const PrimitiveInfo& row : table) map.emplace(row.name, row.type);
        return map;
    }();
    const auto found = by_name.find(name);
    if (found == by_name.end()) return std::nullopt;
    return found->second;
}

std::string nearest_primitive_type(std::string_view name) {
    std::vector<std::string_view> names;
    for (const PrimitiveInfo& row : table) names.push_back(row.name);
    return nearest_name(name, names);
}

}  // namespace infra
