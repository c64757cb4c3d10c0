// Directions of a hemisphere from points of the unit square, so that equal areas stand for equal irradiance.
#pragma once

#include <cmath>
#include <numbers>

#include "common/vec.h"

namespace infra {

/// sin and cos of an angle within pi/4 of 0, to 1e-11: their Taylor series.
inline void small_sin_cos(double t, double& s, double& c) {
    const double q = t * t;
    s = t * (1 + q * (-1.0 / 6 +
                      q * (1.0 / 120 + q * (-1.0 / 5040 + q * (1.0 / 362880 - q * (1.0 / 39916800))))));
    c = 1 + q * (-1.0 / 2 +
                 q * (1.0 / 24 +
                      q * (-1.0 / 720 + q * (1.0 / 40320 + q * (-1.0 / 3628800 + q * (1.0 / 479001600))))));
}

/// Direction of the hemisphere around z for a point of the unit square, with density cos / pi. Neighbours
/// stay neighbours, and x and y turn into x and y. Without a branch, so that a loop works on several at a
/// time.
///   source  Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2 (1997)
inline Vec3 cosine_direction(double x, double y) {
    const double a = 2 * x - 1, b = 2 * y - 1;
    const bool wide = std::fabs(a) > std::fabs(b);
    const double radius = wide ? a : b, other = wide ? b : a;
    double s, c;
    small_sin_cos((std::numbers::pi / 4) * (other / (radius != 0 ? radius : 1.0)), s, c);
    const double below = 1 - radius * radius;
    return {radius * (wide ? c : s), radius * (wide ? s : c), std::sqrt(below > 0 ? below : 0.0)};
}

}  // namespace infra
