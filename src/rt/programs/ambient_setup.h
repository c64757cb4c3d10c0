// The cache of diffuse interreflection as -aa, -ar and -af ask for it.
#pragma once

#include <memory>
#include <string>

#include "rt/ambient/irradiance_cache.h"
#include "rt/programs/program_setup.h"

namespace infra {

/// nullptr when values are not interpolated (-aa 0). A file (-af) is read, or made, even where -ab is 0.
///   program, octree  for the header of a new file
///   throws           Error if the file is of another kind, damaged, or cannot be made
std::unique_ptr<IrradianceCache> open_irradiance_cache(const LoadedScene& loaded,
                                                       const RenderOptions& options,
                                                       const std::string& program, const std::string& octree,
                                                       const WarningSink& warn);

}  // namespace infra
