#include "rt/programs/workers.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

#include "common/interrupt.h"

namespace infra {
namespace {

/// A path's rays are nested calls. TBB's own threads would have half the stack that the main thread usually
/// has.
constexpr std::size_t stack_bytes = std::size_t(8) << 20;

int thread_count(int wanted) {
    if (wanted > 0) return wanted;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

struct Workers::Arena {
    // Without it TBB never runs more threads than there are cores, whatever -n says.
    tbb::global_control limit;
    tbb::global_control stack;
    tbb::task_arena arena;

    explicit Arena(int threads)
        : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
          stack(tbb::global_control::thread_stack_size, stack_bytes),
          arena(threads) {}
};

Workers::Workers(int threads) : count_(thread_count(threads)), arena_(std::make_unique<Arena>(count_)) {}

Workers::~Workers() = default;

void Workers::run(int pieces, const std::function<void(int piece, int worker)>& work) {
    const auto share = [&work](const tbb::blocked_range<int>& range) {
        const int worker = tbb::this_task_arena::current_thread_index();
        for (int piece = range.begin(); piece < range.end(); ++piece) {
            throw_if_interrupted();
            work(piece, worker);
        }
    };
    arena_->arena.execute(
        [&] { tbb::parallel_for(tbb::blocked_range<int>(0, pieces), share, tbb::simple_partitioner()); });
}

}  // namespace infra
