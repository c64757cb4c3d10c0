// One rank's means to work on a frame.
#pragma once

#include <memory>
#include <vector>

#include "rt/programs/frame_painter.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/workers.h"

namespace infra {

struct FrameWork {
    const SampleGrid grid;
    std::vector<std::unique_ptr<FramePainter>> painters;  ///< one a worker
    Workers& workers;

    /// Everything outlives this.
    FrameWork(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
              const FrameOptions& options, Workers& team, Frame& frame);

    /// Fills the base lines, whose traced pixels are all known, for Pass::gaps to begin from.
    void fill_lines();

    /// What has gone wrong on this rank.
    TracerReport report() const;
};

}  // namespace infra
