// A whole picture, by all threads.
#pragma once

#include "common/progress.h"
#include "rt/programs/pixel_tracer.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/workers.h"

namespace infra {

struct FrameOptions {
    int width = 1;
    int height = 1;
    double pixel_jitter = 0;     ///< see PixelTracer
    int sample_spacing = 1;      ///< see SampleGrid; 1 traces every pixel
    double sample_contrast = 0;  ///< see GapFiller
    bool want_depth = false;
    IrradianceCache* cache = nullptr;  ///< of diffuse interreflection, for all threads; nullptr: none
};

/// Renders a view that is set up. The same bits for any number of workers if there is no
/// cache; what one holds depends on which worker comes first.
///   progress  counts width x height pixels
///   faults    what went wrong on the way is added
///   throws    Error "interrupted" after a signal
Frame render_frame(const CompiledScene& scene, const RenderSettings& settings, const View& view,
                   const FrameOptions& options, Workers& workers, Progress& progress, TracerFaults& faults);

}  // namespace infra
