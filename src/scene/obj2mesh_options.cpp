#include "scene/obj2mesh_options.h"

#include "common/raypath.h"

namespace infra {

OptionTable obj2mesh_option_table(Obj2meshSettings& settings) {
    OptionTable options("obj2mesh", "[model.obj|.stl|.ply [mesh.rtm]]");
    options.describe(
        "Makes a mesh of a model's triangles. Without files: OBJ from standard input to standard output.");
    options
        .custom(
            "-a", "s", [&](const OptionValues& v) { settings.materials.push_back(v.text(0)); },
            "file of materials that usemtl or g name")
        .named("materials.rad");
    options
        .custom(
            "-l", "s",
            [&](const OptionValues& v) {
                settings.materials.push_back(require_library_file(v.text(0), "file of materials"));
            },
            "the same, found through RAYPATH")
        .named("materials.rad");
    options.integer("-n", &settings.limits.triangles, "triangles in a cell before it is divided").at_least(1);
    options.integer("-r", &settings.limits.resolution, "resolution limit").at_least(1);
    options.custom(
        "-w", "", [&](const OptionValues&) { settings.quiet = true; }, "no warnings");
    options.custom(
        "-v", "", [&](const OptionValues&) { settings.verbose = true; }, "say what the mesh holds");
    return options;
}

}  // namespace infra
