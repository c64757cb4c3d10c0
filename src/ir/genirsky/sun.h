// The sun's disk as a light source.
#pragma once

#include "common/vec.h"
#include "ir/genirsky/passband.h"

namespace infra::ir {

struct Sun {
    double temperature = 5772;       ///< K, the effective temperature of IAU 2015 resolution B3
    double half_angle_deg = 0.2666;  ///< of the disk, mean over the year
    double transmittance = 1;        ///< of the path to it, in the band
    Vec3 direction{0, 0, 1};         ///< towards it

    /// Of the disk behind the path, W m^-2 sr^-1.
    double radiance(const Passband& passband) const;
    /// Steradians, as RADIANCE's `source` counts a disk of angle a = 2 half_angle: 2 pi (1 - cos(a/2)).
    double solid_angle() const;
};

}  // namespace infra::ir
