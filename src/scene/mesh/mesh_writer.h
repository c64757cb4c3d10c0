// Triangles into an .rtm file.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/mesh/mesh_patches.h"
#include "scene/mesh/mesh_tree.h"

namespace infra {

/// A mesh ready to be written: packed, with its octree in the numbers of packed triangles.
struct PackedMesh {
    Cube cube;
    Octree tree;  ///< sets of numbers of triangles, ascending
    MeshPatches patches;
};

/// Sorts triangles into cells and packs them, in the order of the cells.
///   throws  Error if there are no triangles, and where PatchPacker does
PackedMesh pack_mesh(const MeshTriangles& triangles, const MeshLimits& limits, const WarningSink& warn);

/// Writes an .rtm file, with those modifiers of `materials` that the triangles need.
///   header  lines, "#?RADIANCE" first, without FORMAT=
///   throws  Error when `out` fails
void write_mesh(std::ostream& out, const std::vector<std::string>& header, const PackedMesh& mesh,
                const Scene& materials);

}  // namespace infra
