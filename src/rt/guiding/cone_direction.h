// Directions spread evenly over a cone.
#pragma once

#include <cmath>
#include <numbers>

#include "common/vec.h"

namespace infra {

/// A unit direction whose angle with `axis` has a cosine of at least `least_cosine`, for u, v uniform in [0,
/// 1): with density 1 over the cone's solid angle. Exact for narrow cones too.
inline Vec3 cone_direction(const Vec3& axis, double least_cosine, double u, double v) {
    const double turn = 2 * std::numbers::pi * u;
    const double below = v * (1 - least_cosine);  // 1 less the cosine
    const double across = std::sqrt(below * (2 - below));
    Vec3 x, y;
    make_frame(axis, x, y);
    return x * (across * std::cos(turn)) + y * (across * std::sin(turn)) + axis * (1 - below);
}

}  // namespace infra
