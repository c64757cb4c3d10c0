// The nearest hit found so far while a ray is tested against shapes.
#pragma once

#include <cstdint>

#include "rt/compile/surface_table.h"
#include "rt/ray.h"

namespace infra {

struct HitState {
    double distance = infinite_distance;  ///< also the limit: nothing farther is of interest
    std::uint32_t shape = 0;
    int surface = -1;
    bool front = false;  ///< the surface was met from its front
};

/// Takes the hit at distance t into `state` if it is the best so far.
inline void offer_hit(HitState& state, const SurfaceTable& table, double t, bool front, int surface,
                      std::uint32_t shape) {
    if (t <= same_place || t > state.distance + same_place) return;
    if (t >= state.distance - same_place && state.surface >= 0) {
        if (surface == state.surface || !table.outranks(surface, front, state.surface, state.front)) return;
    } else if (t >= state.distance) {
        return;  // at the limit of the ray
    }
    state.distance = t;
    state.shape = shape;
    state.surface = surface;
    state.front = front;
}

}  // namespace infra
