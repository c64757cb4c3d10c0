#include "rt/text/font.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "common/test_files.h"
#include "common/text_file.h"

namespace infra {
namespace {

struct Malformed {
    const char* file;
    int line;
    const char* message;
};

const Malformed table[] = {
    {"beyond_square.fnt", 1, "256 is not a corner of character 65"},
    {"binary.fnt", 1, "expected the code of a character"},
    {"code_alone.fnt", 1, "the file ends before the number of corners of character 65"},
    {"code_too_large.fnt", 2, "256 is not the code of a character (1 to 255)"},
    {"code_zero.fnt", 1, "0 is not the code of a character"},
    {"count_fraction.fnt", 1, "expected the number of corners of character 65, found \"2.5\""},
    {"count_huge.fnt", 1, "is not the number of corners of character 65 (0 to 32000)"},
    {"count_negative.fnt", 1, "-1 is not the number of corners"},
    {"cut.fnt", 2, "the file ends before a corner of character 65"},
    {"negative.fnt", 2, "-1 is not a corner of character 65 (0 to 255)"},
    {"twice.fnt", 3, "character 65 stands twice"},
    {"word.fnt", 1, "expected a corner of character 65, found \"x\""},
};

const std::string folder = INFRA_SOURCE_DIR "/tests/data/malformed/font/";

TEST(Font, RefusesMalformedFiles) {
    std::set<std::string> covered;
    for (const Malformed& bad : table) {
        covered.insert(bad.file);
        const std::string message =
            test::error_of([&] { Font(read_text_file(folder + bad.file), bad.file); });
        EXPECT_TRUE(message.starts_with(std::string(bad.file) + ":" + std::to_string(bad.line) + ":"))
            << message;
        EXPECT_NE(message.find(bad.message), std::string::npos) << message << "\nwanted: " << bad.message;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        EXPECT_TRUE(covered.contains(entry.path().filename())) << entry.path() << " is in no test";
}

Font font_of(const std::string& text) { return Font(text, "test.fnt"); }

TEST(Glyph, OfASquareWithAHole) {
    const Font font = font_of("67 10  0 0 255 0 255 255 0 255 0 0  80 80 80 170 170 170 170 80 80 80\n");
    const Glyph* glyph = font.glyph('C');
    ASSERT_NE(glyph, nullptr);
    for (double x = 1.3; x < 255; x += 7.1)
        for (double y = 2.7; y < 255; y += 6.3) {
            const bool hole = x > 80 && x < 170 && y > 80 && y < 170;
            EXPECT_EQ(glyph->covers(x, y), !hole) << x << " " << y;
        }
    EXPECT_EQ(font.glyph('D'), nullptr);
}

TEST(Glyph, OfATriangle) {
    const Font font = font_of("65 3 0 0 250 0 125 250 # a triangle\n");
    const Glyph* glyph = font.glyph('A');
    EXPECT_TRUE(glyph->covers(125, 100));
    EXPECT_TRUE(glyph->covers(30.2, 58.9));
    EXPECT_FALSE(glyph->covers(28.8, 60.1));
    EXPECT_FALSE(glyph->covers(125, 252));
    EXPECT_FALSE(glyph->covers(251, 10));
}

TEST(Font, MeanWidthCountsWhatIsDrawn) {
    const Font font = font_of("65 2 100 10 201 20  66 2 28 0 158 40  32 0  67 1 128 5\n");
    EXPECT_EQ(font.mean_width(), (101 + 130) / 2);  // 100..201 and 28..158; a point is not drawn
    EXPECT_TRUE(font.glyph(' ')->is_blank());
    EXPECT_EQ(font_of("").mean_width(), 0);
}

TEST(Font, OursHasAllPrintableCharacters) {
    const std::string path = INFRA_SOURCE_DIR "/lib/helvet.fnt";
    const Font font(read_text_file(path), path);
    for (int c = 33; c < 127; ++c) {
        const Glyph* glyph = font.glyph(static_cast<char>(c));
        ASSERT_NE(glyph, nullptr) << c;
        int inside = 0;
        for (int x = 2; x < character_size; x += 4)
            for (int y = 2; y < character_size; y += 4) inside += glyph->covers(x, y);
        EXPECT_GT(inside, 40) << c;
        EXPECT_LT(inside, 2000) << c << " is a blot";
    }
    EXPECT_TRUE(font.glyph(' ')->is_blank());
}

}  // namespace
}  // namespace infra
