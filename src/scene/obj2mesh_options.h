// The options of obj2mesh.
#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "scene/mesh/mesh_writer.h"

namespace infra {

struct Obj2meshSettings {
    MeshLimits limits;
    std::vector<std::string> materials;  ///< paths of files
    bool quiet = false;
    bool verbose = false;
};

/// The table refers to `settings`, which must outlive it.
OptionTable obj2mesh_option_table(Obj2meshSettings& settings);

}  // namespace infra
