// Directions of many rays of a hemisphere at once.
#pragma once

#include "common/vec.h"

namespace infra {

/// Some of a hemisphere's rays: points of the unit square, and the directions that they stand for
/// (cosine_direction.h). Arrays by coordinate, so that a processor works on several rays at a time.
struct AimedRays {
    static constexpr int most = 32;

    double across[2][most];     ///< points of the unit square
    double direction[3][most];  ///< in the scene; unit length

    Vec3 operator[](int i) const { return {direction[0][i], direction[1][i], direction[2][i]}; }

    /// Fills in the first `count` directions of a hemisphere around `axis`; the frame is orthonormal.
    /// The same numbers on all processors.
    void aim(int count, const Vec3& u, const Vec3& v, const Vec3& axis);
};

}  // namespace infra
