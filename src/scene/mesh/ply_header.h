// The first part of a PLY file: which elements follow, with which properties.
// source: Greg Turk, "The PLY Polygon File Format" (1994).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/mesh/line_reader.h"

namespace infra {

enum class PlyEncoding { text, little_endian, big_endian };

/// A number's type: how many bytes, and what they mean.
struct PlyType {
    enum class Kind : std::uint8_t { signed_integer, unsigned_integer, real };
    Kind kind = Kind::real;
    std::uint8_t size = 4;
};

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::text;
    std::vector<PlyElement> elements;
    int lines = 0;  ///< its own
};

/// Reads up to "end_header" and leaves the stream at the byte behind it.
///   throws  Error "name:line: ..." for anything that is no PLY header
PlyHeader read_ply_header(std::FILE* file, const std::string& name);

}  // namespace infra
