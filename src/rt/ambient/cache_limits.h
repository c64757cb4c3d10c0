// How close together cached values may lie and how far they reach.
#pragma once

#include "rt/ambient/irradiance_value.h"

namespace infra {

struct CacheLimits {
    double accuracy = 0;      ///< -aa: radii are multiplied by it
    double least_radius = 0;  ///< scene units, as all below
    double most_radius = 0;
    double farthest = 0;  ///< places beyond count as at this distance

    /// As RADIANCE's for a scene whose cube has this size: `resolution` (-ar) is that size over the least
    /// radius, 0: no limit.
    static CacheLimits of_scene(double cube_size, double accuracy, int resolution);

    /// Radius of a value whose relative second derivative is `bend`: the extrapolation's error over the disk,
    /// in RADIANCE's measure, is 1.
    double radius_for(double bend) const;
    /// Scales the radii to the value's weight and brings them within the limits, and to no more than twice
    /// each other.
    void confine(IrradianceValue& value) const;
};

}  // namespace infra
