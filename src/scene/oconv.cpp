// oconv: scene descriptions in, octree out.
#include <iostream>

#include "common/format.h"
#include "scene/oconv_options.h"
#include "scene/octree_build.h"
#include "scene/octree_file.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

int oconv(int argc, char** argv) {
    OconvSettings settings;
    OptionTable options = oconv_option_table(settings);
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
