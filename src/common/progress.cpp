#include "common/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "common/format.h"

namespace infra {
namespace {

constexpr int bar_width = 30;
constexpr std::int64_t bar_interval_ms = 100;

/// "1:02:03" or "2:03".
std::string clock_text(double seconds) {
    const auto s = static_cast<long long>(seconds + 0.5);
    return s >= 3600 ? formatted("%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60)
                     : formatted("%lld:%02lld", s / 60, s % 60);
}

}  // namespace

Progress::Progress(std::string program, std::uint64_t total, int report_seconds, bool bar)
    : program_(std::move(program)),
      total_(total),
      report_seconds_(report_seconds),
      bar_(bar && report_seconds <= 0 && isatty(STDERR_FILENO)),
      start_(std::chrono::steady_clock::now()) {
    if (report_seconds_ > 0) {
        std::fprintf(stderr, "%s\n", report_line().c_str());
        next_output_ms_ = 1000LL * report_seconds_;
    }
}

Progress::~Progress() {
    if (bar_ && !finished_) std::fputs("\r\033[K", stderr);
}

double Progress::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Progress::fraction() const {
    if (total_ == 0) return 1;
    return std::min(1.0, double(work_.load(std::memory_order_relaxed)) / double(total_));
}

void Progress::add(std::uint64_t work, std::uint64_t rays) {
    work_.fetch_add(work, std::memory_order_relaxed);
    rays_.fetch_add(rays, std::memory_order_relaxed);
    if (report_seconds_ <= 0 && !bar_) return;
    const auto now = static_cast<std::int64_t>(seconds() * 1000);
    std::int64_t due = next_output_ms_.load(std::memory_order_relaxed);
    if (now < due) return;
    const std::int64_t next = now + (bar_ ? bar_interval_ms : 1000LL * report_seconds_);
    if (!next_output_ms_.compare_exchange_strong(due, next)) return;  // another thread writes this one
    const std::lock_guard lock(output_);
    if (bar_)
        std::fprintf(stderr, "\r%s\033[K", bar_line(seconds()).c_str());
    else
        std::fprintf(stderr, "%s\n", report_line().c_str());
}

void Progress::finish() {
    const std::lock_guard lock(output_);
    if (finished_) return;
    finished_ = true;
    if (bar_) std::fputs("\r\033[K", stderr);
    if (report_seconds_ > 0) std::fprintf(stderr, "%s\n", report_line().c_str());
}

std::string Progress::report_line() const {
    return formatted("%s: %llu rays, %4.2f%% after %5.4f hours", program_.c_str(),
                     static_cast<unsigned long long>(rays()), 100 * fraction(), seconds() / 3600);
}

std::string Progress::bar_line(double elapsed) const {
    const double done = fraction();
    const int filled = static_cast<int>(done * bar_width);
    std::string line =
        program_ + " [" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "]";
    line += formatted(" %3d%%", static_cast<int>(done * 100));
    if (done > 0) line += " " + clock_text(elapsed * (1 - done) / done) + " left";
    return line;
}

}  // namespace infra
