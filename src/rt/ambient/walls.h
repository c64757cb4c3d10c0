// What rises close by around a place: where its irradiance must not be used without a look.
#pragma once

#include <span>

#include "rt/ambient/cache_limits.h"
#include "rt/ambient/hemisphere_mesh.h"

namespace infra {

/// IrradianceValue::walls for a hemisphere of n x n rays: directions in which the outermost of them end
/// within the ellipse of the value's radii at the cache's accuracy. None under a low ceiling, and none for
/// few rays.
///   axis  of the value, in the frame of the corners
std::uint32_t near_walls(std::span<const MeshCorner> corners, int n, const Vec3& axis,
                         const CacheLimits& limits, const IrradianceValue& value);

}  // namespace infra
