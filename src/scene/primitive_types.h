// The one table of primitive types: RADIANCE 6.1's 59 and our own. The reader, oconv, xform, the renderer's
// argument checks and the reference page read it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace infra {

/// Order of the first 59 as in RADIANCE's type list (by decreasing frequency); ours follow.
/// Octree files name their types, so the order is a convenience, not part of the format.
// clang-format off
enum class PrimitiveType : std::uint8_t {
    polygon, cone, sphere, texfunc, ring, cylinder, instance, cup, bubble, tube, mesh, alias,
    plastic, metal, glass, trans, dielectric, plastic2, metal2, trans2, interface, plasfunc, metfunc,
    brightfunc, brightdata, brighttext, colorpict, glow, source, light, illum, spotlight, mist, mirror,
    transfunc, BRTDfunc, BSDF, aBSDF, WGMDfunc, plasdata, metdata, transdata, colorfunc, antimatter,
    colordata, colortext, texdata, mixfunc, mixdata, mixtext, mixpict, prism1, prism2, ashik2,
    spectrum, specfile, specfunc, specdata, specpict,
    emissive, nrlbrdf, thermal,
};
// clang-format on

inline constexpr int radiance_type_count = 59;
inline constexpr int primitive_type_count = 62;

enum class PrimitiveKind : std::uint8_t { surface, volume, alias, material, texture, pattern, mixture };

/// What xform does to a primitive's arguments.
enum class TransformRule : std::uint8_t {
    nothing,  ///< passes them on unchanged
    append,   ///< adds the transform to the string arguments
    numbers,  ///< changes real arguments, whose number must therefore be right
};

/// How many arguments of one sort a type takes: at least `least`, at most `most`, in steps of `step` from
/// `least`; `also` is one more allowed count (-1: none).
struct CountRule {
    static constexpr int any_number = 1 << 30;
    int least = 0;
    int most = 0;
    int step = 1;
    int also = -1;

    constexpr bool allows(std::size_t count) const {
        const auto n = static_cast<long long>(count);
        return n == least || n == also || (n > least && n <= most && (n - least) % step == 0);
    }
    /// In words: "5", "3 or 4", "at least 4", "9, 12, 15, ...".
    std::string text() const;
};

struct PrimitiveInfo {
    PrimitiveType type;
    std::string_view name;
    PrimitiveKind kind;
    CountRule strings;
    CountRule reals;
    std::string_view string_meaning;  ///< names of the string arguments in order, "..." for more of the last
    std::string_view real_meaning;
    TransformRule transform = TransformRule::nothing;

    /// Can be named as a modifier by later primitives.
    bool is_modifier() const { return kind != PrimitiveKind::surface && kind != PrimitiveKind::volume; }
    /// Has a place in space (surface, instance, mesh): oconv puts it into the octree.
    bool is_geometry() const { return !is_modifier(); }
    bool is_ours() const { return static_cast<int>(type) >= radiance_type_count; }
};

/// What is wrong with these numbers of arguments: "3 real arguments where 4 are needed"; "" if they are
/// right.
std::string wrong_counts(const PrimitiveInfo& row, std::size_t strings, std::size_t reals);

/// The arguments of a type in a few words, a hint for the above.
std::string argument_summary(const PrimitiveInfo& row);

/// All rows; row i describes the type with value i.
std::span<const PrimitiveInfo> primitive_types();

namespace detail {
extern const PrimitiveInfo* const primitive_table;
}
inline const PrimitiveInfo& info(PrimitiveType type) {
    return detail::primitive_table[static_cast<std::size_t>(type)];
}
inline std::string_view name(PrimitiveType type) { return info(type).name; }

/// The type of this name, if there is one.
std::optional<PrimitiveType> find_primitive_type(std::string_view name);

/// The name a mistyped type name is most like, or "".
std::string nearest_primitive_type(std::string_view name);

}  // namespace infra
