// Octrees and meshes for scenes that place them.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>

#include "scene/mesh/mesh_triangles.h"
#include "scene/mesh/mesh_writer.h"
#include "scene/mesh/model_reader.h"
#include "scene/octree_file.h"
#include "scene/rad_reader.h"

namespace infra::test {

/// A frozen octree of a scene. Its cells are empty: the renderer has a hierarchy of its own.
inline void write_octree_file(const std::string& path, std::string_view rad) {
    OctreeFile file;
    file.header = {"#?RADIANCE"};
    file.cube = {{-100, -100, -100}, 200};
    file.frozen = true;
    read_rad_text(file.scene, rad, "part.rad", no_warnings());
    std::ofstream out(path, std::ios::binary);
    write_octree(out, file);
}

/// A mesh of a model in OBJ, with the materials that it names.
inline void write_mesh_file(const std::string& path, std::string_view obj, std::string_view materials = "") {
    const std::string model = path + ".obj";
    std::ofstream(model) << obj;
    Scene scene;
    read_rad_text(scene, materials, "materials.rad", no_warnings());
    MeshTriangles triangles;
    TriangleCollector collector(triangles, scene);
    read_model(model, {}, triangles.vertices, collector);
    collector.finish();
    std::ofstream out(path, std::ios::binary);
    write_mesh(out, {"#?RADIANCE"}, pack_mesh(triangles, {}, no_warnings()), scene);
}

}  // namespace infra::test
