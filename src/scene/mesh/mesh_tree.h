// The octree of a mesh: its triangles sorted into cells, by obj2mesh's rules.
#pragma once

#include "scene/mesh/mesh_triangles.h"
#include "scene/octree.h"
#include "scene/warnings.h"

namespace infra {

/// obj2mesh's -n and -r.
struct MeshLimits {
    int triangles = 9;       ///< more of them split a cell
    int resolution = 16384;  ///< no cell is smaller than cube size / resolution, as far as the format allows
};

/// Cube around triangles with a margin, centred on them.
Cube mesh_cube(const Box& box);

/// The sets of leaves are numbers of triangles, ascending. Where more meet in a cell than RADIANCE reads,
/// those beyond are left out of it, which is warned of.
Octree build_mesh_tree(const MeshTriangles& triangles, const Cube& cube, const MeshLimits& limits,
                       const WarningSink& warn);

}  // namespace infra
