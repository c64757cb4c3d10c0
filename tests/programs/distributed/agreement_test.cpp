#include "rt/programs/distributed/agreement.h"

#include <gtest/gtest.h>

#include <atomic>

#include "common/error.h"
#include "thread_team.h"

namespace infra {
namespace {

using test::run_team;

/// What rank 0 says when a step fails; "" when it does not. All others are dismissed then.
std::string outcome_of(int size, const std::function<std::uint64_t(int rank)>& step) {
    std::string said;
    std::atomic<int> dismissed = 0;
    run_team(size, [&](Team& team) {
        try {
            take_step(team, [&] { return step(team.rank()); });
        } catch (const Dismissed&) {
            EXPECT_FALSE(team.leads());
            ++dismissed;
        } catch (const Error& error) {
            EXPECT_TRUE(team.leads());
            said = error.what();
        }
    });
    EXPECT_EQ(dismissed, said.empty() ? 0 : size - 1);
    return said;
}

TEST(Agreement, goes_on_when_all_succeed) {
    for (const int size : {1, 2, 5}) EXPECT_EQ(outcome_of(size, [](int) { return 17; }), "");
}

TEST(Agreement, gives_the_reason_of_one_rank) {
    const auto fail_on = [](int failing) {
        return [failing](int rank) -> std::uint64_t {
            if (rank == failing) throw Error("no such file");
            return 0;
        };
    };
    EXPECT_EQ(outcome_of(3, fail_on(0)), "no such file");
    EXPECT_EQ(outcome_of(3, fail_on(2)), "rank 2 on here: no such file");
    EXPECT_EQ(outcome_of(3, [](int) -> std::uint64_t { throw Error("no such file"); }), "no such file");
    EXPECT_EQ(outcome_of(2,
                         [](int rank) -> std::uint64_t {
                             if (rank == 1) throw std::bad_alloc();
                             return 0;
                         }),
              "rank 1 on here: out of memory");
}

TEST(Agreement, finds_a_rank_that_has_other_files) {
    EXPECT_NE(outcome_of(4, [](int rank) { return rank == 3 ? 1 : 0; }).find("rank 3 on here: it has other"),
              std::string::npos);
}

}  // namespace
}  // namespace infra
