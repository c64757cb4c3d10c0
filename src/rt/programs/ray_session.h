// Rays in, values out: reads as many rays as may be answered together, traces them on all threads, writes in
// order.
#pragma once

#include "rt/programs/program_setup.h"
#include "rt/programs/ray_input.h"
#include "rt/programs/rtrace_options.h"

namespace infra {

/// Answers every ray of `input` on `output`.
///   cache   of diffuse interreflection, nullptr: none
///   throws  Error when the output cannot be written
void answer_rays(const CompiledScene& scene, IrradianceCache* cache, const RtraceOptions& options,
                 const OutputSpec& spec, std::FILE* input, std::FILE* output, const WarningSink& warn);

}  // namespace infra
