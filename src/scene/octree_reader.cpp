#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "common/parse_number.h"
#include "scene/byte_reader.h"
#include "scene/command_pipe.h"
#include "scene/octree_file.h"
#include "scene/octree_format.h"
#include "scene/rad_reader.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

constexpr std::size_t longest_header_line = 1 << 16;
constexpr std::size_t longest_file_name = 4096;
constexpr int largest_id_size = 8;
constexpr int deepest_tree = 64;
constexpr std::int64_t most_primitives = 1 << 28;

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FileHandle open_file(const std::string& path, const char* kind) {
    FileHandle file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw Error(std::string("cannot open ") + kind + " file \"" + path + "\": " + std::strerror(errno));
    return file;
}

/// Lines up to the empty one. throws Error if they say that the file is something else.
std::vector<std::string> read_header(ByteReader& in, std::string_view format, const std::string& kind) {
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

Cube read_cube(ByteReader& in) {
    double values[4];
    for (double& value : values)
        if (!parse_real(in.string(64), value)) in.fail_damaged("its cube is no number");
    if (values[3] < 0) in.fail_damaged("its cube has a negative size");
    return {{values[0], values[1], values[2]}, values[3]};
}

int read_id_size(ByteReader& in, int magic, const std::string& kind) {
    const auto size = in.integer(2) - magic;
    if (size < 1 || size > largest_id_size) in.fail("incompatible " + kind + " format");
    return int(size);
}

/// Reads, checks and (if asked) keeps the tree. Its members must be below `count`.
class TreeReader {
  public:
    TreeReader(ByteReader& in, int id_size, std::int64_t count, Octree* keep)
        : in_(in), id_size_(id_size), count_(count), keep_(keep) {}

    OctreeNode read(int level = 0) {
        switch (in_.byte()) {
            case OctreeTag::empty:
                return empty_node;
            case OctreeTag::leaf:
                return read_leaf();
            case OctreeTag::inner: {
                if (level == deepest_tree) in_.fail_damaged("cells are nested too deep");
                std::array<OctreeNode, 8> children;
                for (OctreeNode& child : children) child = read(level + 1);
                return keep_ ? keep_->add_inner(children) : empty_node;
            }
            default:
                in_.fail_damaged("a cell of no kind");
        }
    }

    /// Whether any cell holds this primitive.
    bool holds(PrimitiveId id) const { return std::size_t(id) < held_.size() && held_[std::size_t(id)]; }

  private:
    OctreeNode read_leaf() {
        const auto size = in_.integer(id_size_);
        if (size < 0 || size > std::int64_t(Octree::largest_set)) in_.fail_damaged("a set of senseless size");
        set_.clear();
        for (std::int64_t i = 0; i < size; ++i) {
            const auto id = in_.integer(id_size_);
            if (id < 0 || id >= count_) in_.fail_damaged("a cell holds a primitive that does not exist");
            if (std::size_t(id) >= held_.size()) held_.resize(std::size_t(id) + 1);
            held_[std::size_t(id)] = true;
            if (keep_) set_.push_back(PrimitiveId(id));
        }
        if (!keep_) return empty_node;
        std::ranges::sort(set_);
        return keep_->add_leaf(set_);
    }

    ByteReader& in_;
    int id_size_;
    std::int64_t count_;
    Octree* keep_;
    std::vector<PrimitiveId> set_;
    std::vector<bool> held_;  // by primitive
};

void check_members(ByteReader& in, const Scene& scene, const TreeReader& tree) {
    for (PrimitiveId id = 0; id < scene.size(); ++id)
        if (tree.holds(id) && !scene.type_info(id).is_geometry())
            in.fail("a cell holds the " + std::string(scene.type_info(id).name) + " \"" +
                    std::string(scene.name(id)) + "\"; is the octree stale?");
}

OctreeFile read_octree(ByteReader& in, const WarningSink& warn, OctreePart part) {
    OctreeFile file;
    file.header = read_header(in, octree_format, "octree");
    const int id_size = read_id_size(in, octree_magic, "octree");
    file.cube = read_cube(in);
    for (auto name = in.string(longest_file_name); !name.empty(); name = in.string(longest_file_name))
        file.scene_files.push_back(std::move(name));
    file.frozen = file.scene_files.empty();
    const std::int64_t count = in.integer(id_size);
    if (count < 0 || count > most_primitives) in.fail_damaged("a senseless number of primitives");
    TreeReader tree(in, id_size, count, part == OctreePart::tree ? &file.tree : nullptr);
    file.tree.root = tree.read();

    if (file.frozen) {
        read_scene_section(in, file.scene, id_size);
    } else {
        for (const std::string& name : file.scene_files) read_rad(file.scene, name, warn);
    }
    if (file.scene.size() != count)
        in.fail(std::to_string(count) + " primitives when the octree was made and " +
                std::to_string(file.scene.size()) + " now; " +
                (file.frozen ? "the octree is damaged" : "octree stale?"));
    check_members(in, file.scene, tree);
    for (PrimitiveId id = 0; id < file.scene.size(); ++id)
        if (file.scene.type_info(id).is_geometry()) check_arguments(file.scene, id);
    return file;
}

}  // namespace

OctreeFile load_octree(const std::string& spec, const WarningSink& warn, OctreePart part) {
    if (spec.empty()) {
        ByteReader in(stdin, "standard input", "octree");
        return read_octree(in, warn, part);
    }
    if (spec[0] == '!') {
        const std::string title = command_title(spec);
        CommandPipe pipe(spec.substr(1));
        ByteReader in(pipe.stream(), title, "octree");
        OctreeFile file = read_octree(in, warn, part);
        if (!pipe.close()) warn("bad status from " + title);
        return file;
    }
    const FileHandle stream = open_file(spec, "octree");
    ByteReader in(stream.get(), spec, "octree");
    return read_octree(in, warn, part);
}

Cube read_octree_cube(const std::string& path) {
    const FileHandle stream = open_file(path, "octree");
    ByteReader in(stream.get(), path, "octree");
    read_header(in, octree_format, "octree");
    read_id_size(in, octree_magic, "octree");
    return read_cube(in);
}

Cube read_mesh_cube(const std::string& path) {
    const FileHandle stream = open_file(path, "mesh");
    ByteReader in(stream.get(), path, "mesh");
    read_header(in, mesh_format, "mesh");
    read_id_size(in, mesh_magic, "mesh");
    return read_cube(in);
}

}  // namespace infra
