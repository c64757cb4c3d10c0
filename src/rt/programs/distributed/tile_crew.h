// The threads of one rank at work on the tiles of a pass, while the thread that made them talks to others.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "rt/programs/frame_painter.h"
#include "rt/programs/workers.h"

namespace infra {

struct TileResult {
    Tile tile;
    std::uint64_t rays = 0;
    std::vector<std::uint64_t> traced;  ///< numbers of the pixels that were traced for it
};

class TileCrew {
  public:
    /// painters: one a worker, of the same frame. Everything outlives this.
    TileCrew(Workers& workers, const std::vector<std::unique_ptr<FramePainter>>& painters, Pass pass);
    TileCrew(const TileCrew&) = delete;
    TileCrew& operator=(const TileCrew&) = delete;
    /// What is not finished is given up.
    ~TileCrew();

    /// Tiles that should be in hand, so that no thread waits while the next tile is on its way.
    int appetite() const;

    void give(const Tile& tile);

    /// The tiles finished since the last call; waits this long for the first of them.
    ///   throws  what stopped a thread
    std::vector<TileResult> take(std::chrono::milliseconds patience);

  private:
    void work();
    std::optional<Tile> next_tile();
    void paint(FramePainter& painter);
    void fail(std::exception_ptr failure);

    Workers& workers_;
    const std::vector<std::unique_ptr<FramePainter>>& painters_;
    const Pass pass_;

    std::mutex mutex_;
    std::condition_variable given_, finished_;
    std::deque<Tile> waiting_;
    std::vector<TileResult> results_;
    std::exception_ptr failure_;
    bool over_ = false;
    std::atomic<bool> stop_{false};
    pthread_t thread_{};
};

}  // namespace infra
