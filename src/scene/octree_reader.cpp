#include <algorithm>

#include "scene/byte_reader.h"
#include "scene/command_pipe.h"
#include "scene/octree_file.h"
#include "scene/octree_format.h"
#include "scene/octree_section.h"
#include "scene/rad_reader.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

constexpr std::size_t longest_file_name = 4096;
constexpr std::int64_t most_primitives = 1 << 28;
constexpr std::int64_t most_primitives_expected = 1 << 22;  // a damaged file may announce more than there are

/// Checks the members, which must be below `count`, and (if asked) keeps the tree.
class MemberCheck : public TreeVisitor {
  public:
    MemberCheck(const ByteReader& in, std::int64_t count, Octree* keep)
        : in_(in), count_(count), keep_(keep) {}

    OctreeNode leaf(std::span<const std::int64_t> members) override {
        set_.clear();
        for (const std::int64_t id : members) {
            if (std::uint64_t(id) >= held_.size()) [[unlikely]]
                make_room(id);
            held_[std::size_t(id)] = true;
        }
        if (!keep_) return empty_node;
        for (const std::int64_t id : members) set_.push_back(PrimitiveId(id));
        std::ranges::sort(set_);
        return keep_->add_leaf(set_);
    }
    OctreeNode inner(std::span<const OctreeNode, 8> children) override {
        return keep_ ? keep_->add_inner(children) : empty_node;
    }

    /// Whether any cell holds this primitive.
    bool holds(PrimitiveId id) const { return std::size_t(id) < held_.size() && held_[std::size_t(id)]; }

  private:
    // As much as has been needed: a damaged file may announce any number of primitives.
    void make_room(std::int64_t id) {
        if (id < 0 || id >= count_) in_.fail_damaged("a cell holds a primitive that does not exist");
        held_.resize(std::size_t(std::min(count_, 2 * id + 1)));
    }

    const ByteReader& in_;
    std::int64_t count_;
    Octree* keep_;
    std::vector<PrimitiveId> set_;
    std::vector<char> held_;  // by primitive
};

void check_members(ByteReader& in, const Scene& scene, const MemberCheck& tree) {
    for (PrimitiveId id = 0; id < scene.size(); ++id)
        if (!scene.type_info(id).is_geometry() && tree.holds(id))
            in.fail("a cell holds the " + std::string(scene.type_info(id).name) + " \"" +
                    std::string(scene.name(id)) + "\"; is the octree stale?");
}

OctreeFile read_octree(ByteReader& in, const WarningSink& warn, OctreePart part) {
    OctreeFile file;
    file.header = read_section_header(in, octree_format, "octree");
    const int id_size = read_id_size(in, octree_magic, "octree");
    file.cube = read_cube(in);
    for (auto name = in.string(longest_file_name); !name.empty(); name = in.string(longest_file_name))
        file.scene_files.push_back(std::move(name));
    file.frozen = file.scene_files.empty();
    const std::int64_t count = in.integer(id_size);
    if (count < 0 || count > most_primitives) in.fail_damaged("a senseless number of primitives");
    MemberCheck tree(in, count, part == OctreePart::tree ? &file.tree : nullptr);
    file.tree.root = read_tree(in, id_size, tree);

    file.scene.reserve(std::size_t(std::min(count, most_primitives_expected)));
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
    const FileHandle stream = open_scene_file(spec, "octree");
    std::setvbuf(stream.get(), nullptr, _IONBF, 0);  // the reader has a buffer
    ByteReader in(stream.get(), spec, "octree");
    return read_octree(in, warn, part);
}

Cube read_octree_cube(const std::string& path) {
    const FileHandle stream = open_scene_file(path, "octree");
    ByteReader in(stream.get(), path, "octree");
    read_section_header(in, octree_format, "octree");
    read_id_size(in, octree_magic, "octree");
    return read_cube(in);
}

Cube read_mesh_cube(const std::string& path) {
    const FileHandle stream = open_scene_file(path, "mesh");
    ByteReader in(stream.get(), path, "mesh");
    read_section_header(in, mesh_format, "mesh");
    read_id_size(in, mesh_magic, "mesh");
    return read_cube(in);
}

}  // namespace infra
