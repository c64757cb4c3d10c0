#include "rt/programs/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "common/error.h"

namespace infra {
namespace {

TEST(Workers, do_every_piece_once) {
    for (const int threads : {1, 2, 5}) {
        Workers workers(threads);
        EXPECT_EQ(workers.count(), threads);
        std::vector<std::atomic<int>> done(1000);
        workers.run(1000, [&](int piece, int) { ++done[piece]; });
        for (const auto& times : done) EXPECT_EQ(times, 1);
    }
}

TEST(Workers, that_run_at_once_have_different_numbers) {
    Workers workers(4);
    std::vector<std::atomic<int>> busy(4);
    std::atomic<bool> clash = false;
    workers.run(2000, [&](int, int worker) {
        if (worker < 0 || worker >= 4 || busy[worker]++ != 0) clash = true;
        --busy[worker];
    });
    EXPECT_FALSE(clash);
}

TEST(Workers, pass_on_an_exception) {
    Workers workers(2);
    const auto fail = [](int piece, int) {
        if (piece == 17) throw Error("seventeen");
    };
    EXPECT_THROW(workers.run(100, fail), Error);
    std::atomic<int> count = 0;
    workers.run(10, [&](int, int) { ++count; });
    EXPECT_EQ(count, 10);
}

TEST(Workers, have_nothing_to_do_without_pieces) {
    Workers workers(0);
    EXPECT_GE(workers.count(), 1);
    workers.run(0, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace infra
