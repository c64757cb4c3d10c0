// The lines of text at the beginning of RADIANCE's files (pictures, octrees, meshes, tables), up to an empty
// line.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace infra {

struct InfoHeader {
    std::vector<std::string> lines;  ///< all of them in order, without line ends

    /// The last FORMAT= line's value, or "".
    std::string format() const;
};

/// Reads a header and leaves the stream at the first byte behind it.
///   returns  nothing if the file does not begin with printable text that an empty line ends
std::optional<InfoHeader> read_info_header(std::FILE* file);

/// True for a "FORMAT=" line.
bool is_format_line(std::string_view line);

/// True if `setting` ("NAME=", "NAME=value", " NAME=value", "command ...") names what `line` sets: the same
/// word before '=' or a blank, both indented or both not.
bool sets_the_same(std::string_view line, std::string_view setting);

/// What stands between the header and the data, as `getinfo -d` prints it: "-Y 512 +X 512" of a picture,
/// "xmin ymin zmin size" of an octree or mesh. Reads it from the stream; nothing if it is neither.
std::optional<std::string> read_dimensions(std::FILE* file);

}  // namespace infra
