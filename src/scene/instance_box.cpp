#include "scene/instance_box.h"

#include "common/raypath.h"
#include "scene/octree_file.h"

namespace infra {

std::array<Vec3, 8> InstanceBox::corners() const {
    std::array<Vec3, 8> result;
    for (int i = 0; i < 8; ++i)
        result[i] = to_world.point(cube.corner(i));
    return result;
}

Cube InstanceBoxes::cube_of_file(PrimitiveId id) {
    const std::string_view name = scene_.strings(id)[0];
    if (const auto known = cubes_.find(name); known != cubes_.end()) return known->second;
    const bool is_mesh = scene_.type(id) == PrimitiveType::mesh;
    const auto path = find_library_file(name);
    if (!path)
        throw scene_.error(id, std::string("cannot find ") + (is_mesh ? "mesh" : "octree") + " file \"" +
                                   std::string(name) + "\"");
    const Cube cube = is_mesh ? read_mesh_cube(*path) : read_octree_cube(*path);
    cubes_.emplace(name, cube);
    return cube;
}

const InstanceBox& InstanceBoxes::at(PrimitiveId id) {
    const auto [entry, is_new] = boxes_.try_emplace(id);
    if (is_new) {
        const auto transform_words = scene_.strings(id).subspan(1);
        if (parse_transform(transform_words, entry->second.to_world) != transform_words.size())
            throw scene_.error(id, "bad transform");
        entry->second.to_local = entry->second.to_world.inverse();
        entry->second.cube = cube_of_file(id);
    }
    return entry->second;
}

}  // namespace infra
