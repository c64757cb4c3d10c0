#include "common/parse_number.h"

#include <gtest/gtest.h>

#include "common/format.h"

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

}  // namespace
}  // namespace infra
