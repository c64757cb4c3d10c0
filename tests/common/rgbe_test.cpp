#include "common/pictures/rgbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace infra {
namespace {

TEST(Rgbe, MatchesRadianceOnKnownPixels) {
    EXPECT_EQ(to_rgbe(1, 1, 1), (Rgbe{128, 128, 128, 129}));
    EXPECT_EQ(to_rgbe(0, 0, 0), (Rgbe{0, 0, 0, 0}));
    EXPECT_EQ(to_rgbe(0.5f, 0.25f, 0.125f), (Rgbe{128, 64, 32, 128}));
    EXPECT_EQ(to_rgbe(37.35f, 34.34f, 31.48f), (Rgbe{149, 137, 125, 134}));
    EXPECT_EQ(to_rgbe(0.999999f, 0, 0), (Rgbe{255, 0, 0, 128}));
    EXPECT_EQ(to_rgbe(1e-33f, 1e-33f, 1e-33f), (Rgbe{0, 0, 0, 0}));
    EXPECT_EQ(to_rgbe(-1, 2, -3), (Rgbe{0, 128, 0, 130}));
}

TEST(Rgbe, DecodesWithHalfAStep) {
    EXPECT_EQ(from_rgbe({128, 128, 128, 129})[0], 1.00390625f);
    EXPECT_EQ(from_rgbe({0, 64, 32, 128})[0], 0.5f / 256);
    EXPECT_EQ(from_rgbe({10, 20, 30, 0})[1], 0.0f);
    EXPECT_EQ(from_rgbe({149, 137, 125, 134})[0], 37.375f);  // a 37.35 that the paper's picture shows
}

TEST(Rgbe, DecodingThenEncodingIsExact) {
    for (int exponent = 30; exponent < 250; exponent += 7)
        for (int mantissa = 128; mantissa < 256; ++mantissa) {
            const Rgbe pixel{static_cast<std::uint8_t>(mantissa), static_cast<std::uint8_t>(mantissa / 2), 3,
                             static_cast<std::uint8_t>(exponent)};
            const auto color = from_rgbe(pixel);
            EXPECT_EQ(to_rgbe(color[0], color[1], color[2]), pixel);
        }
}

TEST(Rgbe, ExtremesDoNotWrap) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(to_rgbe(infinity, 1, 0)[3], 255);
    EXPECT_EQ(to_rgbe(3e38f, 3e38f, 0), (Rgbe{255, 255, 0, 255}));
    EXPECT_EQ(to_rgbe(std::nanf(""), 1, std::nanf("")), (Rgbe{0, 128, 0, 129}));
    for (int e = 1; e < 256; ++e) EXPECT_EQ(rgbe_factor(e), std::ldexp(1.0f, e - 136));
}

}  // namespace
}  // namespace infra
