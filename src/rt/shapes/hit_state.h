// The nearest hit found so far while a ray is tested against shapes.
#pragma once

#include <cstdint>

#include "rt/ray.h"

namespace infra {

/// What decides between surfaces in the same place (within `same_place`).
struct SurfaceRank {
    int modifier = -1;          ///< number of the surface's modifier; the later one wins
    bool has_material = false;
    bool transparent = false;
};

struct HitState {
    double distance = infinite_distance;  ///< also the limit: nothing farther is of interest
    std::uint32_t shape = 0;
    int surface = -1;
    bool front = false;                   ///< the surface was met from its front
};

/// True if `a` beats `b`, both in the same place: material over none, opaque over transparent, front over back, later
/// modifier over earlier (measured behaviour of RADIANCE 6.1).
inline bool outranks(const SurfaceRank& a, bool a_front, const SurfaceRank& b, bool b_front) {
    if (a.has_material != b.has_material) return a.has_material;
    if (a.has_material && a.transparent != b.transparent) return b.transparent;
    if (a_front != b_front) return a_front;
    return a.modifier > b.modifier;
}

/// Takes the hit at distance t into `state` if it is the best so far.
inline void offer_hit(HitState& state, const SurfaceRank* ranks, double t, bool front, int surface,
                      std::uint32_t shape) {
    if (t <= same_place || t > state.distance + same_place) return;
    if (t >= state.distance - same_place && state.surface >= 0) {
        if (surface == state.surface || !outranks(ranks[surface], front, ranks[state.surface], state.front)) return;
    } else if (t >= state.distance) {
        return;  // at the limit of the ray
    }
    state.distance = t;
    state.shape = shape;
    state.surface = surface;
    state.front = front;
}

}  // namespace infra
