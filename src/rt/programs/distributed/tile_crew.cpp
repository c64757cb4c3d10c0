#include "rt/programs/distributed/tile_crew.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "common/error.h"

namespace infra {
namespace {

/// A path's rays are nested calls, and a thread of the library's usual size might have little room for them.
constexpr std::size_t stack_bytes = std::size_t(8) << 20;

/// Starts a thread with that much room; std::thread has no such choice.
pthread_t start_thread(void* (*body)(void*), void* argument) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack_bytes);
    pthread_t thread{};
    const int failure = pthread_create(&thread, &attributes, body, argument);
    pthread_attr_destroy(&attributes);
    if (failure != 0)
        throw Error(std::string("cannot start a thread: ") + std::strerror(failure), {}, Severity::system);
    return thread;
}

}  // namespace

TileCrew::TileCrew(Workers& workers, const std::vector<std::unique_ptr<FramePainter>>& painters, Pass pass)
    : workers_(workers), painters_(painters), pass_(pass) {
    const auto body = [](void* crew) -> void* {
        static_cast<TileCrew*>(crew)->work();
        return nullptr;
    };
    thread_ = start_thread(body, this);
}

TileCrew::~TileCrew() {
    stop_ = true;
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    given_.notify_all();
    pthread_join(thread_, nullptr);
}

int TileCrew::appetite() const { return workers_.count() + 1; }

void TileCrew::give(const Tile& tile) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(tile);
    }
    given_.notify_one();
}

std::vector<TileResult> TileCrew::take(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    finished_.wait_for(lock, patience, [this] { return !results_.empty() || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    return std::exchange(results_, {});
}

/// Every worker takes tiles until there are none to come.
void TileCrew::work() {
    try {
        workers_.run(workers_.count(), [this](int, int worker) { paint(*painters_[worker]); });
    } catch (...) {
        fail(std::current_exception());
    }
}

std::optional<Tile> TileCrew::next_tile() {
    std::unique_lock lock(mutex_);
    given_.wait(lock, [this] { return !waiting_.empty() || over_; });
    if (over_) return std::nullopt;
    const Tile tile = waiting_.front();
    waiting_.pop_front();
    return tile;
}

void TileCrew::paint(FramePainter& painter) {
    while (const std::optional<Tile> tile = next_tile()) {
        TileResult result{.tile = *tile};
        const std::uint64_t rays_before = painter.tracer().ray_count();
        painter.note(&result.traced, &stop_);
        try {
            painter.paint(pass_, *tile);
        } catch (...) {
            painter.note(nullptr, nullptr);
            fail(std::current_exception());
            return;
        }
        painter.note(nullptr, nullptr);
        result.rays = painter.tracer().ray_count() - rays_before;
        {
            const std::lock_guard lock(mutex_);
            results_.push_back(std::move(result));
        }
        finished_.notify_one();
    }
}

/// Nobody goes on after it.
void TileCrew::fail(std::exception_ptr failure) {
    stop_ = true;
    {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(failure);
        over_ = true;
    }
    given_.notify_all();
    finished_.notify_all();
}

}  // namespace infra
