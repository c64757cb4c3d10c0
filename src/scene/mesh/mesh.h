// A triangle mesh with the materials that it brings along, as an .rtm file holds it.
//
// Format: RADIANCE's doc/filefmts.md, "Compiled mesh". Positions are kept there as 32-bit fractions of the
// mesh's cube, normals as coded directions, texture coordinates as 32-bit fractions of their range: a mesh
// that was read has their rounding.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/vec.h"
#include "scene/octree.h"
#include "scene/scene.h"
#include "scene/warnings.h"

namespace infra {

struct Mesh {
    static constexpr std::int32_t no_material = -1;

    struct Triangle {
        std::array<std::uint32_t, 3> vertex;  ///< counterclockwise from the front
        std::int32_t material = no_material;  ///< index into `materials`
        bool smooth = false;                  ///< its vertices have normals
        bool mapped = false;                  ///< its vertices have texture coordinates
    };

    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< unit, as many as positions or none; (0, 0, 0) where a vertex has none
    std::vector<std::array<double, 2>> uv;  ///< as many as positions or none
    std::vector<Triangle> triangles;
    Scene scene;                         ///< the modifiers that came with it
    std::vector<PrimitiveId> materials;  ///< modifiers in `scene`, void_primitive for void
    std::vector<std::string> header;     ///< lines as written, without FORMAT=
    Cube cube;                           ///< encloses it
};

/// Reads an .rtm file, found as a name in a scene is (RAYPATH).
///   throws  Error for a missing, truncated or damaged file
Mesh load_mesh(const std::string& path, const WarningSink& warn);

}  // namespace infra
