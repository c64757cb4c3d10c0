// From surfaces to an octree: the bounding cube and the recursive division, by RADIANCE's rules.
#pragma once

#include "scene/octree.h"
#include "scene/scene.h"
#include "scene/warnings.h"

namespace infra {

/// Width added on every side of the scene's box, and of oconv -b.
inline constexpr double cube_margin = 1e-5;

/// oconv's -n and -r.
struct OctreeLimits {
    int objects = 6;         ///< more primitives than this split a cell
    int resolution = 16384;  ///< no cell is smaller than cube size / resolution
};

/// Cube around the surfaces [first, scene.size()): as wide as their longest extent plus a margin on both
/// sides and centred on them. Size 0 if there are none. A surface of distant sources has no extent.
///   throws  Error for wrong surface arguments and for instances whose file cannot be read
Cube bounding_cube(const Scene& scene, PrimitiveId first);

/// Adds the surfaces [first, scene.size()) to the tree, which holds earlier ones. Surfaces without area are
/// left out and warned of; so are members beyond Octree::largest_set of a cell.
///   throws  Error for wrong surface arguments, and when a surface sticks out of the cube
void add_to_octree(Octree& tree, const Cube& cube, const Scene& scene, PrimitiveId first,
                   const OctreeLimits& limits, const WarningSink& warn);

}  // namespace infra
