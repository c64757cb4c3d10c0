#include <ostream>

#include "common/format.h"
#include "scene/byte_writer.h"
#include "scene/octree_file.h"
#include "scene/octree_format.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

void write_node(ByteWriter& out, const Octree& tree, OctreeNode node) {
    if (Octree::is_inner(node)) {
        out.byte(OctreeTag::inner);
        for (int branch = 0; branch < 8; ++branch) write_node(out, tree, tree.child(node, branch));
    } else if (Octree::is_leaf(node)) {
        const auto set = tree.set(node);
        out.byte(OctreeTag::leaf);
        out.integer(std::int64_t(set.size()), written_id_size);
        for (const PrimitiveId id : set) out.integer(id, written_id_size);
    } else {
        out.byte(OctreeTag::empty);
    }
}

}  // namespace

void write_octree(std::ostream& stream, const OctreeFile& file) {
    ByteWriter out(stream);
    for (const std::string& line : file.header) out.text(line + "\n");
    out.text(std::string(format_key) + std::string(octree_format) + "\n\n");

    out.integer(octree_magic + written_id_size, 2);
    for (int i = 0; i < 3; ++i) out.string(formatted("%.12g", file.cube.origin[i]));
    out.string(formatted("%.12g", file.cube.size));
    if (!file.frozen)
        for (const std::string& name : file.scene_files) out.string(name);
    out.string("");
    out.integer(file.scene.size(), written_id_size);
    write_node(out, file.tree, file.tree.root);
    if (file.frozen) write_scene_section(out, file.scene);
    out.finish();
}

}  // namespace infra
