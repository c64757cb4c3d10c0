#include "rt/programs/output_letters.h"

#include <gtest/gtest.h>

#include <set>

#include "common/error.h"

namespace infra {
namespace {

std::string spelled(const std::vector<const OutputLetter*>& letters) {
    std::string text;
    for (const OutputLetter* letter : letters) text += letter->letter;
    return text;
}

std::string message(std::string_view letters) {
    try {
        parse_output(letters);
    } catch (const Error& error) {
        return error.message();
    }
    return "no error";
}

TEST(OutputLetters, are_radiances_and_each_there_once) {
    std::set<char> known;
    for (const OutputLetter& letter : output_letters()) EXPECT_TRUE(known.insert(letter.letter).second);
    const std::string radiance = "odrRxXvVlLcpnNswWmM~";
    EXPECT_EQ(known, std::set<char>(radiance.begin(), radiance.end()));
}

TEST(OutputLetters, after_t_belong_to_the_tree) {
    const OutputSpec plain = parse_output("ovN");
    EXPECT_EQ(spelled(plain.primary), "ovN");
    EXPECT_FALSE(plain.has_tree());

    const OutputSpec tree = parse_output("vtwLs");
    EXPECT_EQ(spelled(tree.primary), "v");
    EXPECT_EQ(spelled(tree.tree), "wLs");
    EXPECT_FALSE(tree.trace_sources);
    EXPECT_TRUE(parse_output("Tw").trace_sources);
}

TEST(OutputLetters, trace_nothing_when_t_comes_last) {
    const OutputSpec spec = parse_output("Lt");
    EXPECT_EQ(spelled(spec.primary), "L");
    EXPECT_FALSE(spec.has_tree());
    EXPECT_FALSE(spec.needs_radiance());
}

TEST(OutputLetters, tell_whether_a_hit_is_enough) {
    EXPECT_FALSE(parse_output("odcLpNswmM").needs_radiance());
    for (const char* letter : {"r", "R", "x", "X", "v", "V", "l", "n", "W", "tL"})
        EXPECT_TRUE(parse_output(letter).needs_radiance()) << letter;
}

TEST(OutputLetters, count_their_numbers) {
    EXPECT_EQ(parse_output("ov").components(3), 6);
    EXPECT_EQ(parse_output("v").components(7), 7);
    EXPECT_EQ(parse_output("Lsc").components(3), 4);
    EXPECT_EQ(parse_output("otv").components(3), 0);
}

TEST(OutputLetters, refuse_unknown_ones) {
    EXPECT_EQ(message("oq"), "unrecognized output option 'q'");
    EXPECT_EQ(message(""), "empty output specification");
}

}  // namespace
}  // namespace infra
