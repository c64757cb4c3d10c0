// What octrees (.oct) and meshes (.rtm) begin with: lines of text, the size of a number, a cube, a tree of
// cells.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/byte_reader.h"
#include "scene/byte_writer.h"
#include "scene/octree.h"

namespace infra {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Opens for reading; `kind` ("octree") is for the message.
///   throws  Error if it cannot be opened
FileHandle open_scene_file(const std::string& path, const char* kind);

/// Lines up to the empty one, without FORMAT=.
///   throws  Error if they say that the file is something else
std::vector<std::string> read_section_header(ByteReader& in, std::string_view format,
                                             const std::string& kind);
void write_section_header(ByteWriter& out, const std::vector<std::string>& lines, std::string_view format);

/// Bytes that a member of a set takes in this file, 1 to 8.
int read_id_size(ByteReader& in, int magic, const std::string& kind);

/// throws  Error unless it is four numbers and the size is not negative
Cube read_cube(ByteReader& in);
void write_cube(ByteWriter& out, const Cube& cube);

/// What read_tree() calls with the cells of a file, children first; what it returns stands for the cell among
/// its parent's children (empty_node for a cell that holds nothing).
class TreeVisitor {
  public:
    virtual ~TreeVisitor() = default;
    /// Members in the file's order, not checked.
    virtual OctreeNode leaf(std::span<const std::int64_t> members) = 0;
    virtual OctreeNode inner(std::span<const OctreeNode, 8> children) = 0;
};

/// Reads a tree from its root cell on.
///   returns  what the visitor made of the root
///   throws   Error for cells of no kind, nested too deep, or of senseless size
OctreeNode read_tree(ByteReader& in, int id_size, TreeVisitor& visitor);

/// Sets are written in their order; their members take written_id_size bytes.
void write_tree(ByteWriter& out, const Octree& tree);

}  // namespace infra
