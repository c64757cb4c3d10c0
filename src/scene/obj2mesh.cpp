// obj2mesh: a model (OBJ, STL or PLY) in, a mesh for the renderer (.rtm) out.
#include <algorithm>
#include <fstream>
#include <iostream>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "scene/mesh/mesh_report.h"
#include "scene/mesh/mesh_triangles.h"
#include "scene/mesh/mesh_writer.h"
#include "scene/mesh/model_reader.h"
#include "scene/obj2mesh_options.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

Scene read_materials(const std::vector<std::string>& paths, const WarningSink& warn) {
    Scene scene;
    for (const std::string& path : paths) read_rad(scene, path, warn);
    for (PrimitiveId id = 0; id < scene.size(); ++id)
        if (scene.type_info(id).is_geometry())
            throw scene.error(id, "a surface among the materials", "a mesh holds those of its model only");
    return scene;
}

MeshTriangles read_triangles(const std::string& path, const Scene& materials, const WarningSink& warn) {
    MeshTriangles triangles;
    TriangleCollector collector(triangles, materials);
    const ModelSummary summary = read_model(path, {}, triangles.vertices, collector);
    collector.finish();
    const std::string name = path.empty() ? "standard input" : path;
    if (collector.without_area() > 0)
        warn(name + ": left out faces without area: " + std::to_string(collector.without_area()));
    if (collector.crossing_themselves() > 0)
        warn(name + ": faces that cross themselves: " + std::to_string(collector.crossing_themselves()));
    if (summary.unrecognized > 0)
        warn(name + ": " + std::to_string(summary.unrecognized) + " of " +
             std::to_string(summary.statements) + " statements unrecognized");
    if (triangles.size() == 0) throw Error(Location{name}, "no triangles, so no mesh");
    return triangles;
}

int obj2mesh(int argc, char** argv) {
    Obj2meshSettings settings;
    OptionTable options = obj2mesh_option_table(settings);
    const auto files = options.parse(argc, argv);
    if (!files) return 0;
    if (files->size() > 2) throw Error("too many files", "one model, and one mesh to be made of it");
    const WarningSink warn = settings.quiet ? no_warnings() : print_warnings("obj2mesh");

    std::vector<std::string> words(argv, argv + argc);
    words[0] = options.program();
    if (files->size() == 2) words.pop_back();
    const std::vector<std::string> header = {"#?RADIANCE", join_command(words)};

    const Scene materials = read_materials(settings.materials, warn);
    PackedMesh mesh;
    {
        const MeshTriangles triangles = read_triangles(files->empty() ? "" : files->front(), materials, warn);
        mesh = pack_mesh(triangles, settings.limits, warn);
    }
    if (files->size() == 2) {
        AtomicFile file((*files)[1]);
        file.close();
        std::ofstream out(file.part_path(), std::ios::binary);
        write_mesh(out, header, mesh, materials);
        out.close();
        file.commit();
    } else {
        std::ios::sync_with_stdio(false);
        write_mesh(std::cout, header, mesh, materials);
    }
    if (settings.verbose) std::cerr << describe(mesh);
    return 0;
}

}  // namespace
}  // namespace infra

int main(int argc, char** argv) { return infra::run_program("obj2mesh", infra::obj2mesh, argc, argv); }
