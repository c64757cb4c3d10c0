// Triangles packed as .rtm files hold them: vertices coded and shared, up to 256 of them to a patch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/mesh/mesh_triangles.h"
#include "scene/octree.h"

namespace infra {

struct MeshPatches {
    /// A triangle within a patch, with one corner elsewhere, and with two. `far` is a vertex of the whole
    /// mesh.
    struct Local {
        std::array<std::uint8_t, 3> vertex;
        std::int16_t material;
    };
    struct Joining {
        std::uint32_t far;
        std::array<std::uint8_t, 2> vertex;
        std::int16_t material;
    };
    struct DoubleJoining {
        std::array<std::uint32_t, 2> far;
        std::uint8_t vertex;
        std::int16_t material;
    };
    struct Patch {
        std::vector<Local> local;
        std::vector<Joining> joining;
        std::vector<DoubleJoining> double_joining;
    };

    /// Vertices [256 i, 256 (i + 1)) are patch i's.
    std::vector<std::array<std::uint32_t, 3>> positions;  ///< fractions of the cube
    std::vector<std::uint32_t> normals;                   ///< direction codes; no_direction where it has none
    std::vector<std::array<std::uint32_t, 2>> uv;         ///< fractions of the range; u = 0 where it has none
    std::vector<Patch> patches;

    std::array<Uv, 2> uv_range;  ///< lowest and highest, with a margin; zeros if there are none
};

/// Packs triangles one at a time; those of a cell should come together, to be in one patch.
class PatchPacker {
  public:
    PatchPacker(const MeshTriangles& triangles, const Cube& cube);

    /// Number by which cells of the octree name it.
    ///   throws  Error when there are more patches than the format can number
    std::uint32_t add(std::size_t triangle);

    MeshPatches take() { return std::move(packed_); }

  private:
    struct Vertex {
        std::array<std::uint32_t, 3> position;
        std::uint32_t normal;
        std::array<std::uint32_t, 2> uv;
    };

    Vertex encode(std::size_t triangle, int corner) const;
    Vertex vertex_at(std::uint32_t number) const {
        return {packed_.positions[number], packed_.normals[number], packed_.uv[number]};
    }
    std::uint32_t find_or_add(const Vertex& vertex);
    std::uint32_t add_vertex(const Vertex& vertex);
    void grow_table();
    /// The triangle in a patch that has room for it.
    std::uint32_t place(std::array<std::uint32_t, 3> vertices, std::int16_t material);

    const MeshTriangles& triangles_;
    Cube cube_;
    MeshPatches packed_;
    std::vector<std::uint32_t> table_;  // open-addressed hash of vertices
};

}  // namespace infra
