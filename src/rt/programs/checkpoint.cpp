#include "rt/programs/checkpoint.h"

#include <algorithm>
#include <utility>

#include "common/error.h"

namespace infra {

using Clock = std::chrono::steady_clock;

namespace {

Clock::duration interval_of(double seconds) {
    constexpr double longest = 1e8;  // a clock cannot count for ever
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(seconds, longest)));
}

}  // namespace

Checkpoint::Checkpoint(std::string path, const PartialFrame& partial, const std::vector<std::string>& lines,
                       double seconds, const WarningSink& warn)
    : path_(std::move(path)),
      partial_(partial),
      lines_(lines),
      interval_(interval_of(seconds)),
      warn_(warn),
      due_(seconds > 0 && !path_.empty() ? Clock::now() + interval_ : Clock::time_point::max()) {}

/// With the lock.
void Checkpoint::write_now() {
    constexpr int least_share = 50;  // of the time for anything else
    const auto began = Clock::now();
    write_partial(path_, partial_, lines_);
    const auto now = Clock::now();
    if (interval_.count() > 0) due_ = now + std::max<Clock::duration>(interval_, least_share * (now - began));
}

void Checkpoint::write() {
    if (path_.empty()) return;
    const std::lock_guard lock(writing_);
    write_now();
}

void Checkpoint::write_if_possible() {
    try {
        write();
    } catch (const Error& error) {
        warn_(error.what());
    }
}

void Checkpoint::write_if_due() {
    if (Clock::now() < due_.load(std::memory_order_relaxed)) return;
    const std::unique_lock lock(writing_, std::try_to_lock);
    if (!lock || Clock::now() < due_.load()) return;
    try {
        write_now();
    } catch (const Error& error) {
        due_ = Clock::time_point::max();
        warn_(std::string(error.what()) + "; the picture goes on, and is kept only when a signal ends it");
    }
}

}  // namespace infra
