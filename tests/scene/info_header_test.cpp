#include "scene/info_header.h"

#include <gtest/gtest.h>

namespace infra {
namespace {

struct TextFile {
    std::FILE* file = std::tmpfile();
    explicit TextFile(const std::string& text) {
        std::fwrite(text.data(), 1, text.size(), file);
        std::rewind(file);
    }
    ~TextFile() { std::fclose(file); }
};

TEST(InfoHeader, LinesUpToTheEmptyOne) {
    TextFile text("#?RADIANCE\nrpict x.oct\nFORMAT= 32-bit_rle_rgbe \n\n-Y 2 +X 3\nabc");
    const auto header = read_info_header(text.file);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->lines.size(), 3u);
    EXPECT_EQ(header->format(), "32-bit_rle_rgbe");
    EXPECT_EQ(read_dimensions(text.file), "-Y 2 +X 3");
    EXPECT_EQ(std::getc(text.file), 'a');
}

TEST(InfoHeader, WhatIsNone) {
    for (const char* text : {"", "no empty line\n", "\x01\x02\n\n", "\n"}) {
        TextFile file(text);
        EXPECT_FALSE(read_info_header(file.file)) << text;
    }
}

TEST(InfoHeader, DimensionsOfAnOctree) {
    TextFile text(
        std::string("\x01\x1f"
                    "-1\0-2\0-3\0"
                    "10\0rest",
                    18));
    EXPECT_EQ(read_dimensions(text.file), "-1 -2 -3 10");
    TextFile other("hello");
    EXPECT_FALSE(read_dimensions(other.file));
}

TEST(InfoHeader, SettingsToReplace) {
    EXPECT_TRUE(sets_the_same("EXPOSURE=2", "EXPOSURE=16"));
    EXPECT_TRUE(sets_the_same("EXPOSURE=2", "EXPOSURE="));
    EXPECT_TRUE(sets_the_same("EXPOSURE=2", "EXPOSURE"));
    EXPECT_TRUE(sets_the_same("\tEXPOSURE=2", " EXPOSURE="));
    EXPECT_TRUE(sets_the_same("rpict -vf x", "rpict new"));
    EXPECT_FALSE(sets_the_same("\tEXPOSURE=2", "EXPOSURE="));
    EXPECT_FALSE(sets_the_same("EXPOSURES=2", "EXPOSURE=1"));
    EXPECT_FALSE(sets_the_same("rpict -vf x", "rpict"));
    EXPECT_FALSE(sets_the_same("", "X=1"));
}

}  // namespace
}  // namespace infra
