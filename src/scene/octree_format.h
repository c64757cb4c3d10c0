// Constants of the .oct and .rtm formats, for their readers and writers.
#pragma once

#include <string_view>

namespace infra {

inline constexpr std::string_view format_key = "FORMAT=";
inline constexpr std::string_view octree_format = "Radiance_octree";
inline constexpr std::string_view mesh_format = "Radiance_tmesh";

/// The binary part begins with this number plus the bytes that a primitive's number takes.
inline constexpr int octree_magic = 283;
inline constexpr int mesh_magic = 319;

/// Which lists a patch of a mesh has; positions always.
struct PatchFlag {
    static constexpr int positions = 1;
    static constexpr int normals = 2;
    static constexpr int uv = 4;
};

/// A patch of a mesh numbers its vertices in a byte. Its triangles are of three sorts: those within it, those
/// with one corner in another patch, those with two.
inline constexpr int most_patch_vertices = 256;
inline constexpr int most_local_triangles = 512;
inline constexpr int most_joining_triangles = 256;

/// A vertex of a mesh is patch << vertex_bits | number. A triangle is patch << triangle_bits | number, where
/// numbers of triangles with one corner elsewhere begin at first_joining, with two at first_double_joining.
inline constexpr int most_patches = 1 << 22;
inline constexpr int vertex_bits = 8;
inline constexpr int triangle_bits = 10;
inline constexpr int first_joining = 512;
inline constexpr int first_double_joining = 768;

/// First byte of a cell.
struct OctreeTag {
    static constexpr int empty = 0;
    static constexpr int leaf = 1;   ///< then the size of its set and the members
    static constexpr int inner = 2;  ///< then its 8 children
};

}  // namespace infra
