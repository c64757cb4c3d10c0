// An unfinished picture on disk, brought up to date from time to time, so that whatever ends the program
// (SIGKILL, a crash, a node that fails) costs only what was traced since.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "rt/programs/partial_frame.h"
#include "scene/warnings.h"

namespace infra {

class Checkpoint {
  public:
    /// Everything outlives this.
    ///   path     "name.partial"; "": nothing is ever written
    ///   partial  what is written, while threads trace pixels of it
    ///   lines    for its header
    ///   seconds  between two writings, 0: write_if_due never writes
    Checkpoint(std::string path, const PartialFrame& partial, const std::vector<std::string>& lines,
               double seconds, const WarningSink& warn);

    /// Writes at once, atomically. throws Error when it cannot
    void write();
    /// The same; what prevents it is a warning.
    void write_if_possible();

    /// Any thread may ask at any time. Writing takes no more than a fiftieth of the time. What prevents it is
    /// said once, as a warning.
    void write_if_due();

  private:
    void write_now();

    const std::string path_;
    const PartialFrame& partial_;
    const std::vector<std::string>& lines_;
    const std::chrono::steady_clock::duration interval_;
    const WarningSink& warn_;
    std::mutex writing_;
    std::atomic<std::chrono::steady_clock::time_point> due_;
};

}  // namespace infra
