// Sample files: what they mean, and what is wrong with bad ones.
#include "ir/brdftab/sample_file.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::degree;
using test::pi;

template <class Parse>
std::string error_of(Parse parse, const std::string& text) {
    try {
        parse(text, "paint.txt", SampleRules{});
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(SampleColumns, ReadsColumnsInAnyOrder) {
    const SampleSet set = parse_columns(
        "# goniometer\n"
        "value, theta_r, phi_r, theta_i, phi_i\n"
        "0.5, 35, 200, 20, 20   # mirror plane\n\n"
        ".25\t10\t0\t45\t90\n",
        "paint.txt");
    ASSERT_EQ(set.samples.size(), 2u);
    EXPECT_DOUBLE_EQ(set.samples[0].f, 0.5);
    EXPECT_DOUBLE_EQ(set.samples[0].theta_i, 20 * degree);
    EXPECT_DOUBLE_EQ(set.samples[0].theta_r, 35 * degree);
    EXPECT_DOUBLE_EQ(set.samples[0].phi, pi);
    EXPECT_EQ(set.samples[0].line, 3);
    EXPECT_DOUBLE_EQ(set.samples[1].phi, -pi / 2);
    EXPECT_EQ(set.samples[1].line, 5);
}

TEST(SampleColumns, TakesARelativeAzimuthAndAMirrorAtZero) {
    const SampleSet set =
        parse_columns("theta_i phi theta_r value\n20 0 20 1\n", "paint.txt", {.mirror_at_zero = true});
    EXPECT_DOUBLE_EQ(set.samples[0].phi, pi);
}

TEST(SampleColumns, CountsNegativeValuesThatItZeroes) {
    const SampleSet set = parse_columns("theta_i phi theta_r value\n20 0 20 -1e-3\n20 0 30 1\n", "paint.txt",
                                        {.negative_is_zero = true});
    EXPECT_EQ(set.samples[0].f, 0);
    EXPECT_EQ(set.negatives_zeroed, 1u);
}

TEST(SampleColumns, SaysWhatIsWrongAndWhere) {
    const auto error = [](const std::string& text) { return error_of(parse_columns, text); };
    EXPECT_EQ(error(""), "paint.txt:1: the file is empty (the first line names the columns)");
    EXPECT_EQ(error("theta_i phi theta_r value\n"), "paint.txt:1: the file has no samples");
    EXPECT_EQ(error("theta_i phi thetar value\n"),
              "paint.txt:1: unknown column \"thetar\" (did you mean \"theta_r\"?)");
    EXPECT_EQ(error("theta_i phi value\n"), "paint.txt:1: column \"theta_r\" is missing");
    EXPECT_EQ(error("theta_i phi theta_r theta_i value\n"), "paint.txt:1: column \"theta_i\" is given twice");
    EXPECT_EQ(
        error("theta_i phi_i theta_r value\n"),
        "paint.txt:1: azimuths must be phi_i and phi_r, or phi alone (phi is the azimuth of the reflected "
        "minus that of the incident direction)");
    const std::string header = "theta_i phi theta_r value\n10 0 10 1\n";
    EXPECT_EQ(error(header + "10 0 10\n"), "paint.txt:3: found 3 words where the header has 4 columns");
    EXPECT_EQ(error(header + "10 0 10 nan\n"), "paint.txt:3: value: expected a finite number, found \"nan\"");
    EXPECT_EQ(error(header + "10 0 10 -.1\n"),
              "paint.txt:3: negative BRDF value -.1 (-zero-negative takes such values for 0)");
    EXPECT_EQ(error(header + "10 0 -10 1\n"),
              "paint.txt:3: theta_r = -10 deg is out of range (0..90 deg; the other side of the normal has "
              "another azimuth)");
    EXPECT_EQ(error(header + "91 0 10 1\n"),
              "paint.txt:3: theta_i = 91 deg is out of range (0..90 deg; the other side of the normal has "
              "another azimuth)");
    EXPECT_EQ(error(header + "10 400 10 1\n"), "paint.txt:3: phi = 400 deg is out of range (-360..360 deg)");
}

TEST(SampleCuts, ReadsATableForEachIncidentAngle) {
    const SampleSet set = parse_cuts(
        "theta_i 20\n"
        "theta_r 0 90 180\n"
        "0   1 2 3\n"
        "80  4 - 6\n"
        "theta_i 40\n"
        "theta_r 180\n"
        "10  7\n",
        "paint.txt");
    ASSERT_EQ(set.samples.size(), 6u);
    EXPECT_DOUBLE_EQ(set.samples[4].f, 6);
    EXPECT_DOUBLE_EQ(set.samples[4].phi, pi);
    EXPECT_DOUBLE_EQ(set.samples[4].theta_r, 80 * degree);
    EXPECT_DOUBLE_EQ(set.samples[5].theta_i, 40 * degree);
    EXPECT_DOUBLE_EQ(set.samples[5].phi, pi);
}

TEST(SampleCuts, SaysWhatIsWrongAndWhere) {
    const auto error = [](const std::string& text) { return error_of(parse_cuts, text); };
    EXPECT_EQ(error("# nothing\n"), "paint.txt:1: the file has no samples");
    EXPECT_EQ(error("theta_r 0 90\n"),
              "paint.txt:1: a table before its incident angle (start with: theta_i degrees)");
    EXPECT_EQ(error("theta_i 20\n0 1 2\n"),
              "paint.txt:2: values before a line that names the azimuths (for example: theta_r 0 90 180)");
    EXPECT_EQ(error("theta_i 20\ntheta_r 0 90\n0 1\n"),
              "paint.txt:3: found 1 values for 2 azimuths (\"-\" stands for a value not measured)");
    EXPECT_EQ(error("theta_i 20 30\n"), "paint.txt:1: expected one incident angle (theta_i degrees)");
    EXPECT_EQ(error("theta_i 20\ntheta_r\n"),
              "paint.txt:2: no azimuths after theta_r (for example: theta_r 0 90 180)");
}

}  // namespace
}  // namespace infra::ir
