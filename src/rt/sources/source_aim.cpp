#include "rt/sources/source_aim.h"

#include <algorithm>
#include <cmath>

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double least_projection = 1e-4;  // of a part: smaller ones are edge-on

}  // namespace

bool is_out_of_reach(const LightSource& source, const Vec3& point) {
    if (!source.is_glow || source.distant()) return false;
    const double reach = source.reach + source.radius;
    const Vec3 offset = point - source.center;
    return dot(offset, offset) > reach * reach;
}

Vec3 place_on(const LightSource& source, const Part& part, bool alone, double jitter, RandomStream& random) {
    double offset[3] = {part.center[0], part.center[1], 0};
    if (jitter > tiny) {
        offset[0] += jitter * (1 - 2 * random.uniform()) * part.half[0];
        offset[1] += jitter * (1 - 2 * random.uniform()) * part.half[1];
        if (source.extent != LightSource::Extent::flat) offset[2] += jitter * (1 - 2 * random.uniform());
    }
    if (source.round && (!alone || jitter > 0.7)) round_off(source, jitter > tiny, offset);
    return source.center + source.half_axis[0] * offset[0] + source.half_axis[1] * offset[1] +
           source.half_axis[2] * offset[2];
}

bool aim_at(const LightSource& source, const Vec3& from, const Vec3& place, double share, SourceAim& aim) {
    const bool at_infinity = source.distant();
    const Vec3 offset = at_infinity ? place : place - from;
    const double distance = length(offset);
    if (!(distance > 0)) return false;
    aim.direction = offset / distance;
    if (source.is_virtual() && source.disk.missed_by(from, aim.direction)) return false;

    aim.omega = share;
    if (at_infinity) {
        aim.omega *= source.size;
    } else {
        if (source.extent == LightSource::Extent::flat) {
            aim.omega *= -dot(source.normal, aim.direction);
        } else if (source.extent == LightSource::Extent::cylinder) {
            const Vec3& axis = source.half_axis[0];
            const double along = dot(aim.direction, axis);
            aim.omega *= std::sqrt(std::max(0.0, 1.0 - along * along / dot(axis, axis)));
        }
        if (aim.omega <= least_projection) return false;
        if (source.is_glow && distance > source.reach) return false;
        aim.omega *= source.size / (distance * distance);
    }
    if (source.is_spot) {
        if (source.beam.misses(aim.direction)) return false;
        if (!at_infinity) {  // the beam spreads from its focus behind the source
            const double from_focus = distance + source.beam.focal_length;
            aim.omega *= distance * distance / (from_focus * from_focus);
        }
    }
    return true;
}

}  // namespace infra
