// What the normals at a triangle's corners say of it.
#pragma once

#include <array>

#include "common/vec.h"

namespace infra {

struct TriangleNormals {
    bool turned = false;  ///< all point away from the front that the order of the corners gives
    bool smooth = false;  ///< they are not the triangle's own normal
};

/// The triangle's `own` normal and those at its corners, all of unit length.
///   source  RADIANCE's obj2mesh and obj2rad: within acos(0.999995) = 0.18 degrees they are the same
TriangleNormals compare_normals(const Vec3& own, const std::array<Vec3, 3>& at_corners);

}  // namespace infra
