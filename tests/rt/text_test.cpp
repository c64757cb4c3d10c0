// brighttext, colortext and mixtext: where characters stand, and what they are made of.
#include <gtest/gtest.h>

#include "common/test_files.h"
#include "rt/text/text_line.h"
#include "scene_pieces.h"

namespace infra {
namespace {

// A bar in the left half of the square, a full square, a blank.
const char* const font_text = "73 4 0 0 100 0 100 255 0 255\n66 4 0 0 255 0 255 255 0 255\n32 0\n";

// For each place from the left in steps of 10: # inside, . outside.
std::string drawn(const TextLine& line) {
    std::string row;
    for (int x = 5; x < line.width(); x += 10) row += line.covers(x + 0.5, 100) ? '#' : '.';
    return row;
}

TEST(TextLine, UniformSpacingGivesEachCharacterASquare) {
    const Font font(font_text, "test.fnt");
    const TextLine line("I?B I", font, 0);
    EXPECT_EQ(line.width(), 4 * 255);  // the font lacks the question mark
    EXPECT_TRUE(line.covers(99.5, 1));
    EXPECT_FALSE(line.covers(101, 1));
    EXPECT_TRUE(line.covers(256, 254));
    EXPECT_TRUE(line.covers(509, 254));
    EXPECT_FALSE(line.covers(511, 254));
    EXPECT_TRUE(line.covers(3 * 255 + 3, 9));
}

TEST(TextLine, NegativeSpacingIsTheGapBetweenNeighbours) {
    const Font font(font_text, "test.fnt");
    // The box of I ends at the middle of the square, 128; a blank is (128 + 255) / 2 = 191 wide.
    EXPECT_EQ(TextLine("I", font, -20).width(), 20 + 128 + 20);
    EXPECT_EQ(TextLine("IB", font, -20).width(), 20 + 128 + 20 + 255 + 20);
    EXPECT_EQ(TextLine("I I", font, -20).width(), 20 + 128 + 10 + 191 + 10 + 128 + 20);
    EXPECT_EQ(TextLine("?I?", font, -20).width(), 20 + 128 + 20);
    EXPECT_EQ(TextLine("", font, -20).width(), 20);
    EXPECT_EQ(drawn(TextLine("II", font, -20)), "..##########.....##########.....");
}

TEST(TextLine, PositiveSpacingKeepsColumns) {
    const Font font(font_text, "test.fnt");
    const int column = font.mean_width() + 20;
    EXPECT_EQ(TextLine("IBI", font, 20).width(), 20 + 3 * column);
    EXPECT_EQ(TextLine("I    BB", font, 20).width(), 20 + 7 * column);
    const TextLine first("II    B", font, 20), second("BB    B", font, 20);
    const double start = 20 + 6 * column + 5;  // after a wide blank both go on in the same column
    EXPECT_TRUE(first.covers(start, 100) && second.covers(start, 100));
}

class TextScene {
  public:
    explicit TextScene(const std::string& modifier) {
        test::write_file(folder_ / "test.fnt", font_text);
        test::write_file(folder_ / "lines.txt", "IB\n\n B");
        std::string text = modifier;
        for (std::size_t at; (at = text.find('@')) != text.npos;) text.replace(at, 1, folder_ / "");
        scene_ = std::make_unique<test::TracedScene>(
            text + " glow g 0 0 4 1 1 1 0\ng polygon sheet 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n");
    }
    float at(double x, double y) { return scene_->radiance({x, y, 2}, {0, 0, -1})[0]; }

  private:
    test::TemporaryFolder folder_;
    std::unique_ptr<test::TracedScene> scene_;
};

TEST(Text, StandsInStepsFromItsCorner) {
    TextScene scene("void brighttext t 2 @test.fnt @lines.txt 0 11 1 2 0 .5 0 0 0 -1 0 .8 .3 t");
    EXPECT_FLOAT_EQ(scene.at(1.1, 1.5), 0.8f);   // I
    EXPECT_FLOAT_EQ(scene.at(1.3, 1.5), 0.3f);   // its right half
    EXPECT_FLOAT_EQ(scene.at(1.75, 1.5), 0.8f);  // B
    EXPECT_FLOAT_EQ(scene.at(1.1, 2.1), 0.3f);   // above
    EXPECT_FLOAT_EQ(scene.at(0.9, 1.5), 0.3f);   // before
    EXPECT_FLOAT_EQ(scene.at(2.1, 1.5), 0.3f);   // behind
    EXPECT_FLOAT_EQ(scene.at(1.1, 0.5), 0.3f);   // an empty line
    EXPECT_FLOAT_EQ(scene.at(1.1, -0.5), 0.3f);
    EXPECT_FLOAT_EQ(scene.at(1.75, -0.5), 0.8f);  // B of the third line
    EXPECT_FLOAT_EQ(scene.at(1.75, -1.5), 0.3f);
}

TEST(Text, StepsNeedNotBeRectangular) {
    TextScene scene("void colortext t 3 @test.fnt . B 0 15 0 0 0 1 0 0 1 -1 0 1 .5 .5 .1 .5 .5 t");
    EXPECT_FLOAT_EQ(scene.at(1, -0.5), 1.0f);
    EXPECT_FLOAT_EQ(scene.at(0.3, -0.5), 0.1f);
    EXPECT_FLOAT_EQ(scene.at(1.7, -0.5), 0.1f);
    EXPECT_FLOAT_EQ(scene.at(1.7, -0.9), 1.0f);
}

TEST(Text, SpacingShrinksTheSquare) {
    // a step is (191 + 255 * .2) / 255 squares wide: 242 units
    TextScene scene("void brighttext t 3 @test.fnt . II 0 12 0 1 0 2.42 0 0 0 -1 0 1 .1 -.2 t");
    EXPECT_FLOAT_EQ(scene.at(0.45, 0.5), 0.1f);
    EXPECT_FLOAT_EQ(scene.at(0.55, 0.5), 1.0f);  // behind the gap of 51 units
    EXPECT_FLOAT_EQ(scene.at(1.45, 0.5), 1.0f);
    EXPECT_FLOAT_EQ(scene.at(1.55, 0.5), 0.1f);
    EXPECT_FLOAT_EQ(scene.at(2.25, 0.5), 0.1f);
    EXPECT_FLOAT_EQ(scene.at(2.35, 0.5), 1.0f);
}

TEST(Text, MixtextChoosesAModifier) {
    TextScene scene(
        "void brightfunc dark 2 .25 . 0 0 void mixtext t 5 dark void @test.fnt . B 0 9 0 1 0 1 0 0 0 -1 0 t");
    EXPECT_FLOAT_EQ(scene.at(0.5, 0.5), 0.25f);
    EXPECT_FLOAT_EQ(scene.at(1.5, 0.5), 1.0f);
}

// The text chooses one material, which then tells a ray from within what it has travelled in.
TEST(MixText, LeavesTheBodyOfADielectric) {
    const std::string body = "void dielectric d 0 0 5 .5 .5 .5 1.5 0\n", ball = "m sphere s 0 0 4 0 0 0 1\n";
    const test::TemporaryFolder folder;
    test::write_file(folder / "test.fnt", font_text);
    test::TracedScene plain(body + "void alias m d\n" + ball + test::surrounding(1));
    test::TracedScene text(body + "void mixtext m 5 d d " + (folder / "test.fnt") +
                           " . IB 0 9 -1 1 .5 .7 0 0 0 -.9 .1\n" + ball + test::surrounding(1));
    const double seen = plain.radiance({0, 0, 0}, {0, 0, 1})[0];
    EXPECT_NEAR(seen, 0.5 * 0.96 * 2.25 / (1 - 0.04 * 0.25), 0.05);
    EXPECT_EQ(text.radiance({0, 0, 0}, {0, 0, 1})[0], static_cast<float>(seen));
}

}  // namespace
}  // namespace infra
