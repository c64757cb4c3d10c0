#include "scene/xform/primitive.h"

#include <algorithm>
#include <cmath>

namespace infra::xform {
namespace {

using Reals = std::vector<double>;

void set(Reals& reals, std::size_t first, const Vec3& v) {
    for (int i = 0; i < 3; ++i) reals[first + i] = v[i];
}

void move_point(const Transform& transform, Reals& reals, std::size_t first) {
    set(reals, first, transform.point({reals[first], reals[first + 1], reals[first + 2]}));
}

void turn_vector(const Transform& transform, Reals& reals, std::size_t first) {
    set(reals, first, transform.vector({reals[first], reals[first + 1], reals[first + 2]}));
}

void move_polygon(const Transform& transform, bool reverse, Reals& reals) {
    for (std::size_t i = 0; i < reals.size(); i += 3) move_point(transform, reals, i);
    if (!reverse) return;
    std::reverse(reals.begin(), reals.end());  // corners backwards, and each corner's coordinates
    for (std::size_t i = 0; i < reals.size(); i += 3) std::swap(reals[i], reals[i + 2]);
}

/// Transmissivity is that of a unit length; the scaled body as a whole passes as much light as before.
void rescale_transmissivity(Reals& reals, std::size_t first, double scale) {
    for (std::size_t i = first; i < first + 3; ++i) reals[i] = std::pow(reals[i], 1 / scale);
}

/// "mirror1>source3": every part is the name of a surface and gets the prefix.
std::string prefixed_path(const std::string& path, const std::string& prefix) {
    std::string result = prefix + ".";
    for (const char c : path) {
        result += c;
        if (c == '>') result += prefix + ".";
    }
    return result;
}

/// The transform goes behind the string arguments. A repetition (-i) of what stands there already must not
/// reach into it, so "-i 1" comes between.
void append_transform(const Settings& settings, ParsedPrimitive& p) {
    const auto words = settings.transform_words();
    if (!words.empty() && words[0] != "-i") p.strings.insert(p.strings.end(), {"-i", "1"});
    p.strings.insert(p.strings.end(), words.begin(), words.end());
}

PrimitiveType inside_out(PrimitiveType type) {
    switch (type) {
        case PrimitiveType::sphere:
            return PrimitiveType::bubble;
        case PrimitiveType::bubble:
            return PrimitiveType::sphere;
        case PrimitiveType::cone:
            return PrimitiveType::cup;
        case PrimitiveType::cup:
            return PrimitiveType::cone;
        case PrimitiveType::cylinder:
            return PrimitiveType::tube;
        case PrimitiveType::tube:
            return PrimitiveType::cylinder;
        default:
            return type;
    }
}

/// For the types whose row in the table says TransformRule::numbers; their arguments must be of the right
/// number.
void change_numbers(const Settings& settings, ParsedPrimitive& p) {
    const Transform& transform = settings.transform;
    const double scale = transform.magnification();
    Reals& r = p.reals;
    switch (p.type) {
        case PrimitiveType::polygon:
            move_polygon(transform, transform.mirrors() != settings.invert, r);
            break;
        case PrimitiveType::sphere:
        case PrimitiveType::bubble:
            move_point(transform, r, 0);
            r[3] *= scale;
            break;
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
            move_point(transform, r, 0);
            move_point(transform, r, 3);
            for (std::size_t i = 6; i < r.size(); ++i) r[i] *= scale;
            break;
        case PrimitiveType::ring:
            move_point(transform, r, 0);
            turn_vector(transform, r, 3);
            if (settings.invert)
                for (std::size_t i = 3; i < 6; ++i) r[i] = -r[i];
            r[6] *= scale;
            r[7] *= scale;
            break;
        case PrimitiveType::source:
            turn_vector(transform, r, 0);
            break;
        case PrimitiveType::spotlight:
            turn_vector(transform, r, 4);
            break;
        case PrimitiveType::glow:
        case PrimitiveType::emissive:
            if (r.size() > 3) r[3] *= scale;
            break;
        case PrimitiveType::mist:
            if (!settings.prefix.empty())
                for (std::string& path : p.strings) path = prefixed_path(path, settings.prefix);
            for (std::size_t i = 0; i < std::min<std::size_t>(3, r.size()); ++i) r[i] /= scale;
            break;
        case PrimitiveType::dielectric:
            rescale_transmissivity(r, 0, scale);
            break;
        case PrimitiveType::interface:
            rescale_transmissivity(r, 0, scale);
            rescale_transmissivity(r, 4, scale);
            break;
        case PrimitiveType::brighttext:
        case PrimitiveType::colortext:
        case PrimitiveType::mixtext:
            move_point(transform, r, 0);
            turn_vector(transform, r, 3);
            turn_vector(transform, r, 6);
            break;
        default:
            break;
    }
}

}  // namespace

void apply(const Settings& settings, ParsedPrimitive& p, const Location& where) {
    const PrimitiveInfo& row = info(p.type);
    if (row.transform == TransformRule::numbers) {
        const std::string wrong = wrong_counts(row, p.strings.size(), p.reals.size());
        if (!wrong.empty()) throw Error(where, p.description() + ": " + wrong, argument_summary(row));
        change_numbers(settings, p);
    }
    if (row.transform == TransformRule::append) append_transform(settings, p);
    if (row.is_modifier()) return;
    if (settings.invert) p.type = inside_out(p.type);
    if (!settings.new_modifier.empty()) p.modifier = settings.new_modifier;
    if (!settings.prefix.empty()) p.name = settings.prefix + "." + p.name;
}

}  // namespace infra::xform
