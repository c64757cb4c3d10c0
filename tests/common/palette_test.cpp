#include "common/pictures/palette.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_files.h"

namespace infra {
namespace {

/// CIE lightness, 0..100, of an sRGB colour.
double lightness(const Rgb8& color) {
    constexpr double shares[] = {0.2126, 0.7152, 0.0722};
    double luminance = 0;
    for (int c = 0; c < 3; ++c) {
        const double v = color[c] / 255.0;
        luminance += shares[c] * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return luminance > 0.008856 ? 116 * std::cbrt(luminance) - 16 : 903.3 * luminance;
}

TEST(Palette, LightnessOfEachRunsSteadilyOneWay) {
    for (const Palette& palette : palettes()) {
        const double first = lightness(palette_color(0, palette)),
                     last = lightness(palette_color(1, palette));
        EXPECT_GT(std::abs(last - first), 70) << palette.name;
        constexpr int steps = 10;
        for (int i = 0; i < steps; ++i) {
            const double step = (lightness(palette_color((i + 1.) / steps, palette)) -
                                 lightness(palette_color(double(i) / steps, palette))) /
                                (last - first);
            EXPECT_GT(step, 0.4 / steps) << palette.name << " " << i;
            EXPECT_LT(step, 1.6 / steps) << palette.name << " " << i;
        }
    }
}

TEST(Palette, HotIsWhiteOrBlack) {
    EXPECT_EQ(palette_color(1, find_palette("white-hot")), (Rgb8{255, 255, 255}));
    EXPECT_EQ(palette_color(0, find_palette("white-hot")), (Rgb8{0, 0, 0}));
    EXPECT_EQ(palette_color(1, find_palette("black-hot")), (Rgb8{0, 0, 0}));
    EXPECT_EQ(palette_color(0.5, find_palette("gray")), (Rgb8{128, 128, 128}));
    EXPECT_EQ(palette_color(0.5, find_palette("viridis")), (Rgb8{33, 144, 140}));
    EXPECT_EQ(palette_color(0.5), palette_color(0.5, find_palette("inferno")));
}

TEST(Palette, AnUnknownNameListsTheKnown) {
    EXPECT_EQ(test::error_of([] { find_palette("jet"); }),
              "there is no palette \"jet\" (there are inferno, magma, viridis, gray, white-hot, black-hot)");
}

}  // namespace
}  // namespace infra
