// The parts that a light source is divided into for one point, and places on them.
#pragma once

#include "rt/sources/light_source.h"

namespace infra {

/// RADIANCE's limit for one source.
inline constexpr int most_parts = 64;

/// Part of a source: centre and half extent along its axes, in units of the half axes.
struct Part {
    double center[2];
    double half[2];
};

struct Parts {
    Part part[most_parts];
    int count = 0;
};

/// Divides a flat or cylindrical source until no part is larger than size_ratio times its distance, for a ray
/// of this weight; none from behind. Spheres and distant sources stay whole.
void divide_source(const LightSource& source, const Vec3& from, double weight, double size_ratio,
                   Parts& parts);

/// Brings a place given along the source's half axes, each -1..1, into the outline of a round source.
/// spread: the place is random and the mean over all places must be exact; fixed ones lie where RADIANCE has
/// them.
void round_off(const LightSource& source, bool spread, double offset[3]);

}  // namespace infra
