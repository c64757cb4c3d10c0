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

    PlacedShape inner;  ///< where `shape` is an instance: what was met in it
};

/// Takes the hit at distance t into `state` if it is the best so far. False if it is not.
inline bool take_hit(HitState& state, const SurfaceTable& table, double t, bool front, int surface,
                     std::uint32_t shape) {
    if (t > state.distance + same_place) return false;
    if (t >= state.distance - same_place && state.surface >= 0) {
        if (surface == state.surface ? t > state.distance || (t == state.distance && shape >= state.shape)
                                     : !table.outranks(surface, front, state.surface, state.front))
            return false;
    } else if (t >= state.distance) {
        return false;  // at the limit of the ray
    }
    state.distance = t;
    state.shape = shape;
    state.surface = surface;
    state.front = front;
    return true;
}

/// The same for a shape that was tested: what is nearer than `same_place` is where the ray starts.
inline void offer_hit(HitState& state, const SurfaceTable& table, double t, bool front, int surface,
                      std::uint32_t shape) {
    if (t > same_place) take_hit(state, table, t, front, surface, shape);
}

}  // namespace infra
