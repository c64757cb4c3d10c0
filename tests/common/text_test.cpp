// Lines and blanks.
#include "common/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace infra {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) lines.emplace_back(take_line(text));
    return lines;
}

TEST(Text, TakesLineByLine) {
    EXPECT_EQ(lines_of("a b\n\nc"), (std::vector<std::string>{"a b", "", "c"}));
    EXPECT_EQ(lines_of("a\r\nb\n"), (std::vector<std::string>{"a\r", "b"}));
    EXPECT_TRUE(lines_of("").empty());
    std::string_view none;
    EXPECT_EQ(take_line(none), "");
}

TEST(Text, KnowsBlanks) {
    for (const char c : {' ', '\t', '\n', '\v', '\f', '\r'}) EXPECT_TRUE(is_blank(c)) << int(c);
    for (const char c : {'\0', '\b', '\x0e', 'a', '#', '\xa0'}) EXPECT_FALSE(is_blank(c)) << int(c);
}

}  // namespace
}  // namespace infra
