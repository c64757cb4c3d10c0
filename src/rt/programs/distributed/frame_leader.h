// Rank 0's part of a distributed picture: hands out tiles, works on some itself, and gathers what was traced.
//
// Only traced pixels travel. Between two passes everybody is told those of all others, so that each pass
// finds what it would in one process; pixels in between follow from these, and rank 0 computes them at the
// end by rendering the frame as if alone, when there is nothing left to trace.
#pragma once

#include <deque>
#include <vector>

#include "common/progress.h"
#include "rt/programs/checkpoint.h"
#include "rt/programs/distributed/frame_job.h"
#include "rt/programs/distributed/frame_work.h"
#include "rt/programs/distributed/orders.h"
#include "rt/programs/distributed/team.h"

namespace infra {

class FrameLeader {
  public:
    explicit FrameLeader(Team& team) : team_(team) {}

    /// Renders as render_frame() does, to the same bits, with all ranks.
    ///   frame       of the checkpoint; what is known of it is not traced again
    ///   checkpoint  written at the start, from time to time, and when a signal comes
    ///   throws      Error for what happens on any rank; the team is then beyond use
    void render(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                const FrameOptions& options, Workers& workers, Progress& progress, Frame& frame,
                Checkpoint& checkpoint, TracerReport& report);

    /// Tells the others that there are no more frames.
    void dismiss();

    /// Whether the others wait for the next frame, and not for something in the midst of one.
    bool is_idle() const { return idle_; }

  private:
    class PassWork;
    void do_passes(FrameWork& work, Progress& progress, Frame& frame, Checkpoint& checkpoint);
    void share(const Frame& frame, const std::vector<std::uint64_t>& pixels);
    void wait_until_done(TracerReport& report);

    Team& team_;
    std::deque<Team::Message> early_;  // reports of ranks that are done while others are not
    bool idle_ = true;
};

}  // namespace infra
