// A whole picture, by all threads.
#pragma once

#include "common/progress.h"
#include "rt/programs/checkpoint.h"
#include "rt/programs/frame_painter.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/workers.h"

namespace infra {

/// A frame in which nothing is known yet.
Frame empty_frame(int width, int height, bool with_depth, bool with_error, const Channels& channels);

/// Renders a view that is set up. The same bits for any number of workers if there is no
/// cache; what one holds depends on which worker comes first.
///   frame     of options.width x options.height pixels. Pixels known to be traced stay, so that a frame
///             whose work was interrupted at any moment becomes what it would have become.
///   progress  counts the pixels below first_row
///   checkpoint  brought up to date on the way, if it is not nullptr
///   report    what was done, and went wrong, is added
///   throws    Error "interrupted" after a signal
void render_frame(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                  const FrameOptions& options, Workers& workers, Progress& progress, Frame& frame,
                  Checkpoint* checkpoint, TracerReport& report);

}  // namespace infra
