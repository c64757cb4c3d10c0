#include "scene/oconv_options.h"

namespace infra {

OptionTable oconv_option_table(OconvSettings& settings) {
    OptionTable options("oconv", "[input ..]");
    options.text("-i", &settings.input_octree, "octree to add to")
        .named("octree")
        .differing(
            "an octree of scene files that is frozen by `-f` has all its surfaces of negative radius turned "
            "over, not only those in cells that are divided anew");
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
    options.integer("-r", &settings.limits.resolution, "resolution limit")
        .at_least(1)
        .differing(
            "surfaces that coincide are divided down to it only as long as that takes no more than 8 million "
            "tests, and cells below 1e-7 never: RADIANCE goes on until memory is full");
    options.custom(
        "-f", "", [&](const OptionValues&) { settings.freeze = true; }, "freeze: put the scene inside");
    options.custom(
        "-w", "", [&](const OptionValues&) { settings.quiet = true; }, "no warnings");
    return options;
}

}  // namespace infra
