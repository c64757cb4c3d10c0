#pragma once

#include "rt/shapes/hit_state.h"

namespace infra {

/// Disk with an optional round hole.
struct Ring {
    Vec3 center;
    Vec3 unit_normal;
    double inner, outer;  ///< radii
    int surface;

    void intersect(const Vec3& origin, const Vec3& direction, const SurfaceTable& table, std::uint32_t shape,
                   HitState& state) const {
        const double cosine = -dot(direction, unit_normal);
        if (std::fabs(cosine) <= same_place) return;
        const Vec3 offset = origin - center;
        const double t = dot(offset, unit_normal) / cosine;
        const Vec3 at = offset + direction * t;
        const double squared = dot(at, at);
        if (squared > outer * outer || squared < inner * inner) return;
        offer_hit(state, table, t, cosine > 0, surface, shape);
    }
};

}  // namespace infra
