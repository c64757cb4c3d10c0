// tape7 in the layouts of MODTRAN 4 and 5.
#include "ir/genirsky/tape7.h"

#include "common/planck/planck.h"
#include "fixtures.h"

namespace infra::ir {
namespace {

using test::error_of;
using test::GreyAir;
using test::Tape7Layout;

std::string parse_error(const std::string& text) {
    return error_of([&] { parse_tape7(text, "tape7"); });
}

/// A short run with one line replaced; lines count from 1, the first of data is 7.
std::string short_run(int line = 0, const std::string& replacement = {}) {
    const std::string text = test::tape7_run({}, {.first = 900, .last = 910, .step = 5});
    std::string result;
    std::size_t begin = 0;
    for (int number = 1; begin < text.size(); ++number) {
        const std::size_t end = text.find('\n', begin) + 1;
        result += number == line ? replacement : text.substr(begin, end - begin);
        begin = end;
    }
    return result;
}

TEST(Tape7, ReadsEveryLayout) {
    const GreyAir air{.background = 300};
    for (const int version : {4, 5})
        for (const bool solar : {false, true}) {
            const auto runs =
                parse_tape7(test::tape7_run(air, {.version = version, .solar = solar}), "tape7");
            ASSERT_EQ(runs.size(), 1u);
            EXPECT_EQ(runs[0].line, 6);
            EXPECT_TRUE(runs[0].has_radiance);
            EXPECT_EQ(runs[0].transmittance.place.size(), 351u);
            EXPECT_NEAR(runs[0].transmittance.value[17], .6, 1e-8);
            const double b = wavenumber_radiance(air.temperature, 734),
                         ground = wavenumber_radiance(300, 734);
            EXPECT_NEAR(runs[0].path_radiance.value[17], .4 * b, 1e-4 * b);
            EXPECT_NEAR(runs[0].total_radiance.value[17], .4 * b + .6 * ground, 1e-4 * b);
        }
}

// The figures are rounded to five digits; their errors average out.
TEST(Tape7, IntegratesToTheClosedForm) {
    const GreyAir air{.temperature = 288.15, .transmittance = .6, .background = 300};
    const auto runs = parse_tape7(test::tape7_run(air), "tape7");
    const Passband band = Passband::of_band(8, 12);
    const double path = .4 * band_radiance(288.15, 8, 12), total = path + .6 * band_radiance(300, 8, 12);
    EXPECT_NEAR(band_integral(runs[0].path_radiance, band), path, 1e-5 * path);
    EXPECT_NEAR(band_integral(runs[0].total_radiance, band), total, 1e-5 * total);
    EXPECT_NEAR(band_mean(runs[0].transmittance, band, 300), .6, 1e-8);
}

TEST(Tape7, ReadsSeveralRunsWithAndWithoutHeadings) {
    const std::string first = test::tape7_run({.transmittance = .5}),
                      second = test::tape7_run({.transmittance = .4});
    const std::string bare = second.substr(second.find("  700.00"));
    const auto runs = parse_tape7(first + second + bare + "    0\n", "tape7");
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[0].transmittance.value[5], .5);
    EXPECT_EQ(runs[1].transmittance.value[5], .4);
    EXPECT_EQ(runs[2].transmittance.value, runs[1].transmittance.value);
}

TEST(Tape7, ReadsWindowsLineEnds) {
    std::string text;
    for (const char c : short_run()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(parse_tape7(text, "tape7")[0].total_radiance.place.back(), 910);
}

TEST(Tape7, KnowsRunsOfTransmittanceAlone) {
    const auto runs = parse_tape7(test::tape7_transmittance_run(.75), "tape7");
    EXPECT_FALSE(runs[0].has_radiance);
    EXPECT_EQ(runs[0].transmittance.value.back(), .75);
    EXPECT_EQ(error_of([&] { runs[0].require_radiance(); }),
              "tape7:6: a run of transmittances alone (IEMSCT 0) (radiance needs IEMSCT 1 or 2)");
}

TEST(Tape7, RefusesOtherModes) {
    EXPECT_EQ(
        parse_error("card\n    FREQ   TRANS     SOL TR  SOLAR\n"),
        "tape7:2: neither radiances nor transmittances: a run of solar irradiance (IEMSCT 3)? (IEMSCT 1 or 2 "
        "gives radiance)");
    EXPECT_EQ(parse_error("  WAVLEN(NM)      TRAN  PTH_THRML\n"),
              "tape7:1: spectra by \"WAVLEN(NM)\" are not read (tape7 itself, by FREQ in cm-1, not its "
              "convolution)");
    EXPECT_EQ(parse_error("    FREQ LOS  TOT_TRANS  PTH_THRML  TOTAL_RAD\n"),
              "tape7:1: several lines of sight in one run (make a run for each line of sight)");
}

TEST(Tape7, NamesWhatIsWrongInALine) {
    const std::string good = test::tape7_row({}, 905, {});
    const auto changed = [&](std::size_t at, const std::string& text) {
        std::string line = good;
        return short_run(8, line.replace(at, text.size(), text));
    };
    EXPECT_EQ(parse_error(short_run()), "no error");
    EXPECT_EQ(parse_error(changed(2, "899.00")), "tape7:8: frequency 899 cm-1 does not come after 900 cm-1");
    EXPECT_EQ(parse_error(changed(8, " 1.50000000")), "tape7:8: transmittance 1.5 is not within 0..1");
    EXPECT_EQ(
        parse_error(changed(8, "        NaN")),
        "tape7:8:17: TOT_TRANS: expected a number, found \"NaN\" (columns end where their headings end)");
    EXPECT_EQ(parse_error(changed(96, std::string(11, ' '))), "tape7:8:97: column TOTAL_RAD is blank");
    EXPECT_EQ(parse_error(changed(96, "***********")),
              "tape7:8:97: TOTAL_RAD: expected a number, found \"***********\" (columns end where their "
              "headings end)");
    EXPECT_EQ(parse_error(changed(10, "\t")),
              "tape7:8:11: a tab: columns must be of fixed width (blanks, no tabs, as MODTRAN writes them)");
    EXPECT_EQ(parse_error(changed(96, "-1.0000E-07")), "tape7:8: TOTAL_RAD is negative: -1e-07");
    EXPECT_EQ(parse_error(short_run(8, good.substr(0, 103) + "\n")),
              "tape7:8:98: the line is cut off in column TOTAL_RAD");
    EXPECT_EQ(parse_error(short_run(8, good.substr(0, 90) + "\n")), "tape7:8:97: column TOTAL_RAD is blank");
}

TEST(Tape7, RefusesFilesThatAreNone) {
    EXPECT_EQ(parse_error(""), "tape7:1: there are no spectra: no line of headings that begins with FREQ");
    EXPECT_EQ(parse_error("1 2 3\n4 5 6\n"),
              "tape7:2: there are no spectra: no line of headings that begins with FREQ");
    const std::string whole = short_run();
    EXPECT_EQ(parse_error(short_run(10, "")),
              "tape7:9: the run has no end (a line -9999. ends every run: is the file cut off?)");
    const std::string bare = whole.substr(whole.find("  900.00"));
    EXPECT_EQ(parse_error(whole + bare.substr(0, bare.size() - 8)),
              "tape7:13: the run has no end (a line -9999. ends every run: is the file cut off?)");
    EXPECT_EQ(parse_error(test::tape7_headings(5) + " -9999.\n"),
              "tape7:2: a run needs at least 2 lines of data");
}

}  // namespace
}  // namespace infra::ir
