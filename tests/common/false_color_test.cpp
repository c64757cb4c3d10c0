#include "common/pictures/false_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/pictures/bitmap_font.h"

namespace infra {
namespace {

double lightness(const Rgb8& color) { return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]; }

TEST(Palette, GrowsLighterAllTheWay) {
    for (int i = 0; i < 255; ++i)
        EXPECT_LE(lightness(palette_color(i / 255.)), lightness(palette_color((i + 1) / 255.)) + 0.5) << i;
    EXPECT_EQ(palette_color(-1), palette_color(0));
    EXPECT_EQ(palette_color(2), palette_color(1));
    EXPECT_EQ(palette_color(0.5), (Rgb8{188, 55, 84}));
}

TEST(FalseColor, MapsTheRange) {
    const std::vector<float> values{30, 35, 40, std::numeric_limits<float>::quiet_NaN()};
    const Image8 image = false_color(values, 2, 2, {.low = 30, .high = 40, .quantity = {}, .unit = {}});
    EXPECT_EQ(image.at(0, 0), palette_color(0));
    EXPECT_EQ(image.at(1, 0), palette_color(0.5));
    EXPECT_EQ(image.at(0, 1), palette_color(1));
    EXPECT_EQ(image.at(1, 1), (Rgb8{128, 128, 128}));
}

TEST(FalseColor, LegendStandsBesideThePicture) {
    const std::vector<float> values(300 * 200, 33.0f);
    const FalseColorScale scale{.low = 31, .high = 38, .quantity = "radiance", .unit = "W.m-2.sr-1"};
    const Image8 image = false_color_with_legend(values, 300, 200, scale);
    EXPECT_GT(image.width, 300 + text_width("radiance"));
    EXPECT_EQ(image.height, 200);
    EXPECT_EQ(image.at(150, 100), palette_color(2. / 7));
    const Image8 small = false_color_with_legend(std::vector<float>(4, 31.0f), 2, 2, scale);
    EXPECT_GE(small.height, 100);
}

TEST(Ticks, AreRoundNumbersInside) {
    EXPECT_EQ(round_ticks(0, 10, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    const auto ticks = round_ticks(31.2, 37.4, 8);
    EXPECT_EQ(ticks, (std::vector<double>{32, 33, 34, 35, 36, 37}));
    for (const double high : {1e-7, 0.3, 12., 1e5, 3.3e12})
        for (int count = 1; count < 12; ++count) {
            const auto marks = round_ticks(0.1 * high, high, count);
            EXPECT_LE(marks.size(), std::size_t(count));
            for (const double mark : marks) EXPECT_TRUE(mark >= 0.0999 * high && mark <= 1.0001 * high);
        }
    EXPECT_TRUE(round_ticks(1, 1, 5).empty());
}

TEST(Unit, GetsItsSuperscripts) {
    EXPECT_EQ(pretty_unit("W.m-2.sr-1"), "W·m⁻²·sr⁻¹");
    EXPECT_EQ(pretty_unit("W·m⁻²·sr⁻¹"), "W·m⁻²·sr⁻¹");
    EXPECT_EQ(pretty_unit("K"), "K");
    EXPECT_EQ(pretty_unit("m2"), "m²");
    EXPECT_EQ(pretty_unit(""), "");
}

TEST(Font, DrawsEachCharacterApart) {
    EXPECT_EQ(text_width("abc"), 3 * font_advance);
    EXPECT_EQ(text_width("abc", 2), 6 * font_advance);
    Image8 unknown(8, 10);
    draw_text(unknown, 0, 0, "\xE2\x82\xAC", {255, 255, 255});  // the euro sign is not in the font
    for (const char* text : {"0", "8", "A", "z", "~", "⁻", "²", "·", "°", "µ", "λ"}) {
        Image8 image(8, 10);
        draw_text(image, 0, 0, text, {255, 255, 255});
        int dots = 0;
        for (const Rgb8& pixel : image.pixels) dots += pixel[0] == 255;
        EXPECT_GT(dots, 1) << text;
        EXPECT_NE(image.pixels, unknown.pixels) << text;
    }
    Image8 image(4, 4);
    draw_text(image, -3, -3, "clipped \xFF", {255, 255, 255}, 3);
}

}  // namespace
}  // namespace infra
