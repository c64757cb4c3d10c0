// The options of oconv.
#pragma once

#include <string>

#include "common/options.h"
#include "scene/octree_build.h"

namespace infra {

struct OconvSettings {
    std::string input_octree;
    Cube cube;  ///< -b; size 0: from the scene
    OctreeLimits limits;
    bool freeze = false;
    bool quiet = false;
};

/// The table refers to `settings`, which must outlive it.
OptionTable oconv_option_table(OconvSettings& settings);

}  // namespace infra
