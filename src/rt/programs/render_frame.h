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
    int first_row = 0;                 ///< rows above it are left as they are
    int sample_spacing = 1;            ///< see SampleGrid; 1 traces every pixel
    double sample_contrast = 0;        ///< see GapFiller
    IrradianceCache* cache = nullptr;  ///< of diffuse interreflection, for all threads; nullptr: none
};

/// A frame in which nothing is known yet.
Frame empty_frame(int width, int height, bool with_depth, bool with_error, const Channels& channels);

/// Renders a view that is set up. The same bits for any number of workers if there is no
/// cache; what one holds depends on which worker comes first.
///   frame     of options.width x options.height pixels. Pixels known to be traced stay, so that a frame
///             whose work was interrupted at any moment becomes what it would have become.
///   progress  counts the pixels below first_row
///   faults    what went wrong on the way is added
///   throws    Error "interrupted" after a signal
void render_frame(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                  const FrameOptions& options, Workers& workers, Progress& progress, Frame& frame,
                  TracerFaults& faults);

}  // namespace infra
