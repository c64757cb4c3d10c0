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

/// First byte of a cell.
struct OctreeTag {
    static constexpr int empty = 0;
    static constexpr int leaf = 1;   ///< then the size of its set and the members
    static constexpr int inner = 2;  ///< then its 8 children
};

}  // namespace infra
