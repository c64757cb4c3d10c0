#include "common/progress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace infra {
namespace {

TEST(Progress, CountsFromManyThreads) {
    Progress progress("rpict", 4000, 0);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 500; ++i) progress.add(1, 3);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(progress.rays(), 6000u);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.5);
    EXPECT_EQ(progress.report_line(), "rpict: 6000 rays, 50.00% after 0.0000 hours");
    EXPECT_EQ(progress.bar_line(83), "rpict [###############---------------]  50% 1:23 left");
    progress.add(1990, 0);
    EXPECT_EQ(progress.bar_line(7200 * 3990. / 10).substr(38), "  99% 2:00:00 left");
}

TEST(Progress, ReportsAtTheStartAndTheEnd) {
    testing::internal::CaptureStderr();
    {
        Progress progress("rpict", 10, 1000);
        progress.add(10, 25);
        progress.finish();
        progress.finish();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "rpict: 0 rays, 0.00% after 0.0000 hours\nrpict: 25 rays, 100.00% after 0.0000 hours\n");
}

TEST(Progress, IsSilentWithoutTerminalOrReports) {
    testing::internal::CaptureStderr();
    {
        Progress progress("rpict", 10, 0);
        progress.add(10, 25);
        progress.finish();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace infra
