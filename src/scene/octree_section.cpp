#include "scene/octree_section.h"

#include <array>
#include <cerrno>
#include <cstring>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "scene/octree_format.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

constexpr std::size_t longest_header_line = 1 << 16;
constexpr int largest_id_size = 8;
constexpr int deepest_tree = 64;

class TreeWalk {
  public:
    TreeWalk(ByteReader& in, int id_size, TreeVisitor& visitor)
        : in_(in), id_size_(id_size), visitor_(visitor) {}

    OctreeNode cell(int level) {
        switch (in_.byte()) {
            case OctreeTag::empty:
                return empty_node;
            case OctreeTag::leaf:
                return leaf();
            case OctreeTag::inner: {
                if (level == deepest_tree) in_.fail_damaged("cells are nested too deep");
                std::array<OctreeNode, 8> children;
                for (OctreeNode& child : children) child = cell(level + 1);
                return visitor_.inner(children);
            }
            default:
                in_.fail_damaged("a cell of no kind");
        }
    }

  private:
    OctreeNode leaf() {
        const auto size = in_.integer(id_size_);
        if (size < 0 || size > std::int64_t(Octree::largest_set)) in_.fail_damaged("a set of senseless size");
        in_.integers(members_, std::size_t(size), id_size_);
        return visitor_.leaf(members_);
    }

    ByteReader& in_;
    int id_size_;
    TreeVisitor& visitor_;
    std::vector<std::int64_t> members_;
};

void write_node(ByteWriter& out, const Octree& tree, OctreeNode node) {
    if (Octree::is_inner(node)) {
        out.byte(OctreeTag::inner);
        for (int branch = 0; branch < 8; ++branch) write_node(out, tree, tree.child(node, branch));
    } else if (Octree::is_leaf(node)) {
        const auto set = tree.set(node);
        out.byte(OctreeTag::leaf);
        out.integer(std::int64_t(set.size()), written_id_size);
        out.integers(set);
    } else {
        out.byte(OctreeTag::empty);
    }
}

}  // namespace

FileHandle open_scene_file(const std::string& path, const char* kind) {
    FileHandle file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw Error(std::string("cannot open ") + kind + " file \"" + path + "\": " + std::strerror(errno));
    return file;
}

std::vector<std::string> read_section_header(ByteReader& in, std::string_view format,
                                             const std::string& kind) {
    std::vector<std::string> lines;
    bool formatted = false;
    for (std::string line = in.line(longest_header_line); !line.empty() && line != "\r";
         line = in.line(longest_header_line)) {
        if (lines.empty() && (line[0] < ' ' || line[0] > '~')) in.fail("this is no " + kind);
        if (!line.starts_with(format_key)) {
            lines.push_back(std::move(line));
            continue;
        }
        std::string found = line.substr(format_key.size());
        found.erase(found.find_last_not_of(" \r\t") + 1);
        formatted = true;
        if (found != format) in.fail("this is no " + kind + " but a file of format " + found);
    }
    if (!formatted) in.fail("this is no " + kind);
    return lines;
}

void write_section_header(ByteWriter& out, const std::vector<std::string>& lines, std::string_view format) {
    for (const std::string& line : lines) out.text(line + "\n");
    out.text(std::string(format_key) + std::string(format) + "\n\n");
}

int read_id_size(ByteReader& in, int magic, const std::string& kind) {
    const auto size = in.integer(2) - magic;
    if (size < 1 || size > largest_id_size) in.fail("incompatible " + kind + " format");
    return int(size);
}

Cube read_cube(ByteReader& in) {
    double values[4];
    for (double& value : values)
        if (!parse_real(in.string(64), value)) in.fail_damaged("its cube is no number");
    if (values[3] < 0) in.fail_damaged("its cube has a negative size");
    return {{values[0], values[1], values[2]}, values[3]};
}

void write_cube(ByteWriter& out, const Cube& cube) {
    for (int i = 0; i < 3; ++i) out.string(formatted("%.12g", cube.origin[i]));
    out.string(formatted("%.12g", cube.size));
}

OctreeNode read_tree(ByteReader& in, int id_size, TreeVisitor& visitor) {
    return TreeWalk(in, id_size, visitor).cell(0);
}

void write_tree(ByteWriter& out, const Octree& tree) { write_node(out, tree, tree.root); }

}  // namespace infra
