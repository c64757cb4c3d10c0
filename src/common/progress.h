// How far a render is: RADIANCE's report lines every -t seconds, and a bar when people watch.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace infra {

/// Counts are added by any thread; output goes to stderr at most ten times a second. Nothing is written
/// unless asked for.
class Progress {
  public:
    /// total: units of work (pixels). report_seconds: > 0 writes "rpict: 1234 rays, 12.34% after 0.0123
    /// hours" that often, at the start and at the end. bar: show a bar while stderr is a terminal (not with
    /// report lines).
    Progress(std::string program, std::uint64_t total, int report_seconds, bool bar = true);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Wipes the bar.
    ~Progress();

    /// Work done and rays traced since the last call.
    void add(std::uint64_t work, std::uint64_t rays);
    /// Writes the last report and wipes the bar.
    void finish();

    std::uint64_t rays() const { return rays_.load(std::memory_order_relaxed); }
    double fraction() const;

    /// "rpict: 1234 rays, 12.34% after 0.0123 hours".
    std::string report_line() const;
    /// "rpict [#####-----]  50% 1:23 left", without a line end; `seconds` since the start.
    std::string bar_line(double seconds) const;

  private:
    double seconds() const;

    std::string program_;
    std::uint64_t total_;
    int report_seconds_;
    bool bar_;
    std::chrono::steady_clock::time_point start_;
    std::atomic<std::uint64_t> work_{0};
    std::atomic<std::uint64_t> rays_{0};
    std::atomic<std::int64_t> next_output_ms_{0};
    std::mutex output_;
    bool finished_ = false;
};

}  // namespace infra
