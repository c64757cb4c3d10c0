#pragma once

#include "rt/shapes/hit_state.h"
#include "rt/shapes/quadratic.h"

namespace infra {

/// sphere (normals outward) or bubble (inward).
struct Sphere {
    Vec3 center;
    double radius;
    int surface;
    bool inward;

    void intersect(const Vec3& origin, const Vec3& direction, const SurfaceTable& table, std::uint32_t shape,
                   HitState& state) const {
        const Vec3 offset = origin - center;
        double roots[2];
        const int count =
            solve_quadratic(1.0, dot(direction, offset), dot(offset, offset) - radius * radius, roots);
        for (int i = 0; i < count; ++i)
            if (roots[i] > same_place)
                return offer_hit(state, table, roots[i], (i == 0) != inward, surface, shape);
    }
    Vec3 normal(const Vec3& point) const { return (point - center) * ((inward ? -1.0 : 1.0) / radius); }
};

}  // namespace infra
