#pragma once

#include "rt/shapes/hit_state.h"
#include "rt/shapes/quadratic.h"

namespace infra {

/// cone, cylinder (normals outward), cup, tube (inward): the side between two parallel disks of one axis,
/// without ends. source: with z the distance along the axis from p0, the radius is r0 + slope z; the side is
/// where the squared distance from the axis equals the squared radius.
struct Cone {
    Vec3 p0;    ///< centre of the disk at z = 0
    Vec3 axis;  ///< unit vector towards the other disk
    double length;
    double r0;
    double slope;  ///< (r1 - r0) / length; 0 for a cylinder
    int surface;
    bool inward;

    void intersect(const Vec3& origin, const Vec3& direction, const SurfaceTable& table, std::uint32_t shape,
                   HitState& state) const {
        const Vec3 offset = origin - p0;
        const double z = dot(offset, axis);
        const double dz = dot(direction, axis);
        const Vec3 radial = offset - axis * z;
        const Vec3 d_radial = direction - axis * dz;
        const double r = r0 + slope * z;
        const double dr = slope * dz;
        double roots[2];
        const double a = dot(d_radial, d_radial) - dr * dr;
        const double half_b = dot(radial, d_radial) - r * dr;
        const int count = solve_quadratic(a, half_b, dot(radial, radial) - r * r, roots);
        for (int i = 0; i < count; ++i) {
            if (roots[i] <= same_place) continue;
            const double at = z + roots[i] * dz;
            if (at < 0 || at > length) continue;
            const bool entering = a * roots[i] + half_b < 0;  // squared distance less squared radius falls
            offer_hit(state, table, roots[i], entering != inward, surface, shape);
            return;
        }
    }
    Vec3 normal(const Vec3& point) const {
        const Vec3 offset = point - p0;
        const Vec3 radial = offset - axis * dot(offset, axis);
        const double size = infra::length(radial);
        const Vec3 outward = size > 0 ? normalize(radial / size - axis * slope) : axis * -1.0;
        return inward ? -outward : outward;
    }
};

}  // namespace infra
