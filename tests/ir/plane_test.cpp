#include "ir/plane.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/error.h"
#include "pictures.h"

namespace infra::ir {
namespace {

TEST(Plane, TakesOneChannelOrTheMeanOfAll) {
    const Picture picture = ramp(3, 2, 3);
    const Plane one = plane_of(picture, 2);
    EXPECT_EQ(one.width, 3);
    EXPECT_EQ(one.height, 2);
    EXPECT_EQ(one.values, (std::vector<float>{200, 201, 202, 210, 211, 212}));
    EXPECT_EQ(plane_of(picture).values, (std::vector<float>{100, 101, 102, 110, 111, 112}));
}

TEST(Plane, RefusesAChannelThatIsNotThere) {
    try {
        plane_of(ramp(2, 2, 3), 3);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the picture has no channel 3 (its channels are 0 to 2)");
    }
}

TEST(BlockMean, AveragesBlocksAndCutsTheRest) {
    const Picture coarse = block_mean(ramp(5, 4, 2), 2);
    EXPECT_EQ(coarse.width, 2);
    EXPECT_EQ(coarse.height, 2);
    EXPECT_EQ(coarse.channels, 2);
    // The first block holds 0, 1, 10, 11 and, in the second channel, 100 more.
    EXPECT_EQ(coarse.pixels, (std::vector<float>{5.5, 105.5, 7.5, 107.5, 25.5, 125.5, 27.5, 127.5}));
}

TEST(BlockMean, RefusesBlocksLargerThanThePicture) {
    EXPECT_THROW(block_mean(ramp(5, 4, 1), 5), Error);
    EXPECT_THROW(block_mean(ramp(5, 4, 1), 0), Error);
}

TEST(FiniteRange, LeavesOutWhatIsNotFinite) {
    const float infinite = std::numeric_limits<float>::infinity();
    const std::vector<float> values{infinite, 3, -2, std::numeric_limits<float>::quiet_NaN(), 7};
    EXPECT_EQ(finite_range(values).low, -2);
    EXPECT_EQ(finite_range(values).high, 7);
    EXPECT_EQ(finite_range(std::vector<float>{infinite}).high, 0);
}

}  // namespace
}  // namespace infra::ir
