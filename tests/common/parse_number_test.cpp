#include "common/parse_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "common/format.h"
#include "common/short_number.h"

namespace infra {
namespace {

TEST(ParseReal, ReadsTheFormsOfScenes) {
    const std::pair<const char*, double> cases[] = {
        {"3", 3},     {"+3", 3},     {"-3", -3},         {".5", .5},   {"5.", 5},
        {"1e-1", .1}, {"-.5", -.5},  {"1.5E+3", 1500},   {"+.5", .5},  {"0", 0},
        {"007", 7},   {"1e-400", 0}, {"-12.25", -12.25}, {"2e5", 2e5}, {"1e308", 1e308},
    };
    for (const auto& [text, expected] : cases) {
        double value = -99;
        EXPECT_TRUE(parse_real(text, value)) << text;
        EXPECT_EQ(value, expected) << text;
    }
}

TEST(ParseReal, RefusesEverythingElse) {
    for (const char* text :
         {"",    " 3", "3 ", "x", "3x",  "nan", "NaN",  "inf",   "-inf",   "infinity", "1e",
          "1e+", ".",  "-",  "+", "+-3", "--3", "0x10", "1e999", "-1e999", "1,5",      "1.2.3"}) {
        double value = -99;
        EXPECT_FALSE(parse_real(text, value)) << text;
        EXPECT_EQ(value, -99) << text;
    }
}

TEST(ParseInt, ReadsWholeNumbersThatFit) {
    int value = 0;
    EXPECT_TRUE(parse_int("+12", value));
    EXPECT_EQ(value, 12);
    EXPECT_TRUE(parse_int("-2147483648", value));
    for (const char* text : {"", "1.0", "1e3", "2147483648", "+-1", "x", "3 "})
        EXPECT_FALSE(parse_int(text, value)) << text;
    long long large = 0;
    EXPECT_TRUE(parse_int("2147483648", large));
    EXPECT_EQ(large, 2147483648LL);
}

TEST(Format, WordsAndCommands) {
    EXPECT_EQ(formatted("%-5d|%.3g", 12, 0.5), "12   |0.5");
    EXPECT_EQ(split_words("  a\tb\n c "), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(join_command({"rpict", "-e", "a b", "", "say \"hi\" now", "x"}),
              "rpict -e \"a b\" \"\" 'say \"hi\" now' x");
}

TEST(ShortNumber, IsTheNearestDouble) {
    std::mt19937 random(7);
    for (int i = 0; i < 100000; ++i) {
        const int size = 1 + int(random() % 7), point = int(random() % 10);
        std::string text = random() % 2 ? "-" : "";
        for (int k = 0; k < size; ++k) text += k == point && size > 1 ? '.' : char('0' + random() % 10);
        double value = 0;
        ASSERT_EQ(parse_short_number(text + " 12345678", value), text.size()) << text;
        ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
        ASSERT_EQ(std::signbit(value), text[0] == '-') << text;
    }
}

TEST(ShortNumber, LeavesAllElse) {
    for (const char* text :
         {"",    " ",   "-",   ".",   "-.",  "--1",      "+1",  "1e3", "1.2.3",  "1..",
          "0x1", "12a", "a12", "nan", "inf", "12345678", "1/2", "1:2", "\"12\"", "1\x80"}) {
        double value = 5;
        EXPECT_EQ(parse_short_number(std::string(text) + "         ", value), 0u) << text;
        EXPECT_EQ(parse_short_number(std::string(text), value), 0u) << text;
        EXPECT_EQ(value, 5) << text;
    }
    double value = 5;
    EXPECT_EQ(parse_short_number("12", value), 0u);  // it might go on
}

}  // namespace
}  // namespace infra
