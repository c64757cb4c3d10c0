#include "ir/region_marks.h"

#include <gtest/gtest.h>

namespace infra::ir {
namespace {

constexpr Rgb8 dark{10, 0, 20};
constexpr Rgb8 light{250, 240, 160};
constexpr Rgb8 black{0, 0, 0};
constexpr Rgb8 white{255, 255, 255};

TEST(RegionMarks, FramesWithTheColourThatStandsOut) {
    Image8 image(60, 40, dark);
    mark_region(image, {5, 4, 55, 36, "deck"}, 31.5);
    EXPECT_EQ(image.at(5, 4), white);
    EXPECT_EQ(image.at(54, 35), white);
    EXPECT_EQ(image.at(4, 4), dark);
    EXPECT_EQ(image.at(55, 35), dark);

    Image8 bright(60, 40, light);
    mark_region(bright, {5, 4, 55, 36, "deck"}, 31.5);
    EXPECT_EQ(bright.at(5, 20), black);
}

TEST(RegionMarks, ShiftsByTheOffset) {
    Image8 image(60, 60, dark);
    mark_region(image, {0, 0, 60, 40, ""}, 1, 15);
    EXPECT_EQ(image.at(0, 14), dark);
    EXPECT_EQ(image.at(0, 15), white);
    EXPECT_EQ(image.at(0, 54), white);
    EXPECT_EQ(image.at(0, 55), dark);
}

}  // namespace
}  // namespace infra::ir
