#include "ir/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/error.h"
#include "pictures.h"

namespace infra::ir {
namespace {

std::string error_of(const Picture& picture, const Region& region) {
    try {
        region_statistics(picture, region);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(RegionStatistics, MeasuresEachChannel) {
    // Columns 1 and 2 of rows 0 and 1: 1, 2, 11, 12.
    const auto statistics = region_statistics(ramp(4, 3, 2), {1, 0, 3, 2, "box"});
    ASSERT_EQ(statistics.size(), 2u);
    EXPECT_EQ(statistics[0].count, 4u);
    EXPECT_DOUBLE_EQ(statistics[0].mean, 6.5);
    EXPECT_DOUBLE_EQ(statistics[0].deviation, std::sqrt(101.0 / 3));
    EXPECT_DOUBLE_EQ(statistics[0].minimum, 1);
    EXPECT_DOUBLE_EQ(statistics[0].maximum, 12);
    EXPECT_DOUBLE_EQ(statistics[1].mean, 106.5);
    EXPECT_DOUBLE_EQ(statistics[1].deviation, statistics[0].deviation);
}

TEST(RegionStatistics, ASinglePixelHasNoDeviation) {
    const auto statistics = region_statistics(ramp(4, 3, 1), {3, 2, 4, 3, ""});
    EXPECT_EQ(statistics[0].count, 1u);
    EXPECT_DOUBLE_EQ(statistics[0].mean, 23);
    EXPECT_EQ(statistics[0].deviation, 0);
}

TEST(RegionStatistics, KeepsASmallDeviationOnALargeMean) {
    Picture picture = ramp(2, 1, 1);
    picture.pixels = {4096.0f, 4096.0f + 1.0f / 2048};
    EXPECT_DOUBLE_EQ(region_statistics(picture, {0, 0, 2, 1, ""})[0].deviation, std::sqrt(0.5) / 2048);
}

TEST(RegionStatistics, RefusesRegionsThatAreEmptyOrOutside) {
    const Picture picture = ramp(4, 3, 1);
    EXPECT_EQ(error_of(picture, {2, 0, 2, 3, ""}),
              "region 2 0 2 3 holds no pixel (give x0 y0 x1 y1 with x0 < x1 and y0 < y1)");
    EXPECT_EQ(error_of(picture, {0, 0, 5, 3, ""}),
              "region 0 0 5 3 is not within the picture (it has 4 x 3 pixels)");
    EXPECT_EQ(error_of(picture, {-1, 0, 2, 2, ""}),
              "region -1 0 2 2 is not within the picture (it has 4 x 3 pixels)");
}

TEST(RegionStatistics, LeavesPixelsWithoutAValueOut) {
    Picture picture = ramp(4, 3, 1);
    const Statistics rest = region_statistics(picture, {2, 1, 4, 2, ""})[0];
    picture.at(1, 1)[0] = std::numeric_limits<float>::quiet_NaN();
    const Statistics found = region_statistics(picture, {1, 1, 4, 2, ""})[0];
    EXPECT_EQ(found.count, 2u);
    EXPECT_EQ(found.missing, 1u);
    EXPECT_EQ(found.mean, rest.mean);
    EXPECT_EQ(found.deviation, rest.deviation);
    EXPECT_EQ(found.minimum, rest.minimum);
    EXPECT_EQ(found.maximum, rest.maximum);
    EXPECT_EQ(error_of(picture, {1, 1, 2, 2, "mast"}), "region mast has no pixel with a value in channel 0");
}

}  // namespace
}  // namespace infra::ir
