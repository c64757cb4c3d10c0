#include "rt/sources/source_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace infra {
namespace {

constexpr double tiny = 1e-6;

// Halves a part along its longer axis until it is small for its distance.
// limit: squared distance beyond which an extent of one half axis need not be divided further.
void divide(const LightSource& source, const Vec3& from, const Part& part, const double limit[2], int budget,
            Parts& parts) {
    const Vec3 center =
        source.center + source.half_axis[0] * part.center[0] + source.half_axis[1] * part.center[1];
    const Vec3 offset = center - from;
    const double distance2 = dot(offset, offset);
    const double need[2] = {limit[0] * part.half[0] * part.half[0], limit[1] * part.half[1] * part.half[1]};
    if (budget < 2 || (distance2 >= need[0] && distance2 >= need[1])) {
        parts.part[parts.count++] = part;
        return;
    }
    const int axis = need[0] > need[1] ? 0 : 1;
    for (const double side : {-0.5, 0.5}) {
        Part half = part;
        half.half[axis] *= 0.5;
        half.center[axis] += side * part.half[axis];
        divide(source, from, half, limit, budget / 2, parts);
    }
}

// Brings samples of a ball from the cube of the same volume into its outline.
void round_off_ball(double offset[3]) {
    double largest = 0, sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double squared = offset[i] * offset[i];
        largest = std::max(largest, squared);
        sum += squared;
    }
    const double trim = sum > tiny * tiny ? std::sqrt(largest / sum) / 0.7236 : 0.0;
    for (int i = 0; i < 3; ++i) offset[i] *= trim;
}

// Brings samples of a disk from the square of the same area into its outline. Places that are spread at
// random are mapped without change of area, so that their mean is exact (Shirley & Chiu, "A Low Distortion
// Map Between Disk and Square", JGT 2, 1997); fixed ones lie where RADIANCE has them.
void round_off_disk(double offset[3], bool spread) {
    constexpr double widen = 1.1283791670955126;  // radius over half the side of the square: 2 / sqrt(pi)
    const double u = offset[0], v = offset[1];
    offset[2] = 0;
    if (!spread) {
        offset[0] = widen * u * std::sqrt(1.0 - 0.5 * v * v);
        offset[1] = widen * v * std::sqrt(1.0 - 0.5 * u * u);
        return;
    }
    const bool wide = std::fabs(u) > std::fabs(v);
    const double radius = wide ? u : v;
    if (radius == 0) return;
    const double angle = (std::numbers::pi / 4) * (wide ? v / u : u / v);
    offset[wide ? 0 : 1] = widen * radius * std::cos(angle);
    offset[wide ? 1 : 0] = widen * radius * std::sin(angle);
}

}  // namespace

void divide_source(const LightSource& source, const Vec3& from, double weight, double size_ratio,
                   Parts& parts) {
    const Part whole{{0, 0}, {1, 1}};
    const double reach = size_ratio > tiny ? 2.0 * weight / size_ratio : 0.0;
    const double limit[2] = {reach * reach * dot(source.half_axis[0], source.half_axis[0]),
                             reach * reach * dot(source.half_axis[1], source.half_axis[1])};
    switch (source.extent) {
        case LightSource::Extent::flat:
            if (size_ratio <= tiny) break;
            if (dot(from - source.center, source.normal) <= 0) return;
            return divide(source, from, whole, limit, most_parts, parts);
        case LightSource::Extent::cylinder: {
            if (size_ratio <= tiny) break;
            const Vec3 offset = from - source.center;
            const double axis2 = dot(source.half_axis[0], source.half_axis[0]);
            const double along = dot(offset, source.half_axis[0]);
            const double distance2 = dot(offset, offset);
            const double from_axis2 = distance2 - along * along / axis2;
            const double radius2 = 1.365 * dot(source.half_axis[1], source.half_axis[1]);
            if (from_axis2 <= radius2) return;  // within the cylinder
            if (from_axis2 <= 4 * radius2 || distance2 >= limit[0]) break;
            const double lengthwise[2] = {limit[0], 0};
            return divide(source, from, whole, lengthwise, most_parts, parts);
        }
        default:
            break;
    }
    parts.part[parts.count++] = whole;
}

void round_off(const LightSource& source, bool spread, double offset[3]) {
    if (source.extent == LightSource::Extent::sphere) {
        round_off_ball(offset);
    } else {
        round_off_disk(offset, spread);
    }
}

}  // namespace infra
