// How a reader of OBJ, STL or PLY hands on what it reads: one face at a time, so that files may be larger
// than memory.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/vec.h"

namespace infra {

/// Texture coordinates.
using Uv = std::array<double, 2>;

/// One corner of a face: places in the lists of a VertexLists; no_index where it has none.
struct Corner {
    static constexpr std::int32_t no_index = -1;

    std::int32_t position = no_index;
    std::int32_t uv = no_index;
    std::int32_t normal = no_index;
};

/// Vertices read so far.
struct VertexLists {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< unit length, or (0, 0, 0) where the file has that
    std::vector<Uv> uv;
};

/// What the file calls the faces that follow. Empty: nothing.
struct FaceNames {
    std::string material;             ///< usemtl
    std::string map;                  ///< usemap
    std::string object;               ///< o; the name of a solid
    std::vector<std::string> groups;  ///< g
    int changes = 0;                  ///< another number whenever a name has changed
};

struct Face {
    const VertexLists& vertices;
    std::span<const Corner> corners;  ///< at least 3, in the lists of `vertices`
    const FaceNames& names;
    int number = 0;  ///< in its file, from 1
    std::string_view file;
    int line = 0;  ///< 0: the file has no lines
};

class FaceSink {
  public:
    virtual ~FaceSink() = default;
    virtual void face(const Face& face) = 0;
    /// A comment of an OBJ file, with its '#'.
    virtual void comment(std::string_view) {}
};

}  // namespace infra
