// oconv: scene descriptions in, octree out.
#include <iostream>

#include "common/format.h"
#include "common/options.h"
#include "scene/octree_build.h"
#include "scene/octree_file.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

struct Settings {
    std::string input_octree;
    Cube cube;  ///< -b; size 0: from the scene
    OctreeLimits limits;
    bool freeze = false;
    bool quiet = false;
};

OptionTable make_options(Settings& settings) {
    OptionTable options("oconv", "[input ..]");
    options.text("-i", &settings.input_octree, "octree to add to");
    options
        .custom(
            "-b", "ffff",
            [&](const OptionValues& v) {
                if (v.real(3) <= 0) v.reject("the size must be positive");
                settings.cube = {Vec3(v.real(0), v.real(1), v.real(2)) - Vec3(cube_margin),
                                 v.real(3) + 2 * cube_margin};
            },
            "bounding cube")
        .named("xmin ymin zmin size");
    options.integer("-n", &settings.limits.objects, "surfaces in a cell before it is divided").at_least(1);
    options.integer("-r", &settings.limits.resolution, "resolution limit").at_least(1);
    options.custom(
        "-f", "", [&](const OptionValues&) { settings.freeze = true; }, "freeze: put the scene inside");
    options.custom(
        "-w", "", [&](const OptionValues&) { settings.quiet = true; }, "no warnings");
    return options;
}

int oconv(int argc, char** argv) {
    Settings settings;
    OptionTable options = make_options(settings);
    const auto inputs = options.parse(argc, argv);
    if (!inputs) return 0;
    const WarningSink warn = settings.quiet ? no_warnings() : print_warnings("oconv");

    OctreeFile file;
    if (settings.input_octree.empty()) {
        file.header = {"#?RADIANCE"};
    } else {
        if (settings.cube.size > 0) throw Error("only one of -b and -i");
        file = load_octree(settings.input_octree, warn, OctreePart::tree);
        if (file.frozen && !settings.freeze && !inputs->empty()) warn("frozen octree");
    }
    std::vector<std::string> words(argv, argv + argc);
    words[0] = options.program();
    file.header.push_back(join_command(words));
    file.frozen = file.frozen || settings.freeze;

    const PrimitiveId first = file.scene.size();
    for (const std::string& input : *inputs) {
        const bool from_stdin = input == "-";
        read_rad(file.scene, from_stdin ? "" : input, warn);
        if (from_stdin) file.frozen = true;
        file.scene_files.push_back(input);
    }

    if (settings.cube.size > 0) file.cube = settings.cube;
    if (file.cube.size == 0) file.cube = bounding_cube(file.scene, first);
    add_to_octree(file.tree, file.cube, file.scene, first, settings.limits, warn);
    std::ios::sync_with_stdio(false);
    write_octree(std::cout, file);
    return 0;
}

}  // namespace
}  // namespace infra

int main(int argc, char** argv) { return infra::run_program("oconv", infra::oconv, argc, argv); }
