#include <ostream>

#include "scene/byte_writer.h"
#include "scene/octree_file.h"
#include "scene/octree_format.h"
#include "scene/octree_section.h"
#include "scene/scene_section.h"

namespace infra {

void write_octree(std::ostream& stream, const OctreeFile& file) {
    ByteWriter out(stream);
    write_section_header(out, file.header, octree_format);
    out.integer(octree_magic + written_id_size, 2);
    write_cube(out, file.cube);
    if (!file.frozen)
        for (const std::string& name : file.scene_files) out.string(name);
    out.string("");
    out.integer(file.scene.size(), written_id_size);
    write_tree(out, file.tree);
    if (file.frozen) write_scene_section(out, file.scene);
    out.finish();
}

}  // namespace infra
