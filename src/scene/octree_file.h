// RADIANCE's .oct files, frozen (the scene inside) and not (names of scene files inside); both directions.
// Format: an information header of text lines, then big-endian binary; RADIANCE's doc/filefmts.md describes
// it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/octree.h"
#include "scene/scene.h"
#include "scene/warnings.h"

namespace infra {

/// How much load_octree() keeps. The whole file is read and checked in any case.
enum class OctreePart {
    scene,  ///< header, cube and primitives: all that our renderer needs
    tree,   ///< and the tree
};

/// What an .oct file says.
struct OctreeFile {
    std::vector<std::string> header;  ///< lines as written, "#?RADIANCE" first, without FORMAT=
    Cube cube;
    std::vector<std::string> scene_files;  ///< names or "!commands"; empty for a frozen octree
    bool frozen = false;
    Scene scene;
    Octree tree;  ///< empty unless read with OctreePart::tree
};

/// Reads an octree from a file, from a command's output ("!oconv scene.rad") or from standard input ("").
/// For an octree that is not frozen the scene files are read again; their number of primitives must agree.
/// Arguments of surfaces are checked, those of modifiers not.
///   throws  Error for a missing, truncated, damaged or stale file
OctreeFile load_octree(const std::string& spec, const WarningSink& warn, OctreePart part = OctreePart::scene);

/// Cube of an octree file, or of a mesh file (.rtm), without reading further.
///   throws  Error for a missing or damaged file
Cube read_octree_cube(const std::string& path);
Cube read_mesh_cube(const std::string& path);

/// Writes an octree; with its scene if `file.frozen`, else with the names of scene files.
///   throws  Error when `out` fails
void write_octree(std::ostream& out, const OctreeFile& file);

}  // namespace infra
