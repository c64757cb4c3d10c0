// The air between camera and scene: closed forms, bands and channels, bad files.
#include "common/data/air_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "test_files.h"

namespace infra {
namespace {

constexpr double source = 31.47802;  // 15 C in 8-12 um

// VALIDATION V11: homogeneous air of one temperature, optical depth 0.1 at distance 10.
std::string homogeneous() {
    return formatted("#%% bands 8 12\n# range, transmittance, radiance\n10 %.15g %.15g\n", std::exp(-0.1),
                     -std::expm1(-0.1) * source);
}

double through(const AirPath& air, double near, double far, double radiance) {
    Spectrum transmittance(3), added(3);
    air.stretch(near, far, transmittance, added);
    return double(transmittance[1]) * radiance + double(added[1]);
}

TEST(AirPath, HomogeneousAirFollowsBeersLaw) {
    const AirPath air = AirPath::parse(homogeneous(), "air", {});
    constexpr double panel = 37.34626;  // 25 C
    for (const auto& [depth, expected] :
         {std::pair{0.1, 36.78782}, {0.5, 35.03729}, {1.0, 33.63683}, {2.0, 32.27220}})
        EXPECT_NEAR(through(air, 0, 100 * depth, panel), expected, 1e-5 * expected);
}

TEST(AirPath, StretchesInARowAreOne) {
    const AirPath air = AirPath::parse("100 .9 2\n1000 .5 9\n3000 .2 11\n", "air", {});
    for (const double middle : {50.0, 600.0, 2500.0, 5000.0}) {
        const double whole = through(air, 0, 6000, 20);
        EXPECT_NEAR(through(air, 0, middle, through(air, middle, 6000, 20)), whole, 1e-5 * whole);
    }
    EXPECT_NEAR(through(air, 0, 1000, 20), 0.5 * 20 + 9, 1e-5);
    EXPECT_NEAR(through(air, 0, 0, 20), 20, 1e-5);
}

TEST(AirPath, ChannelsTakeTheBandsTheyCover) {
    const AirPath air =
        AirPath::parse("#% bands 8 10 12\n1000 .5 4 .25 2\n", "air", Channels::spectral(4, 8000, 12000));
    Spectrum transmittance(4), added(4);
    air.stretch(0, 1000, transmittance, added);
    // longest first: two channels of 10-12 um, each with half the band's radiance, times 4
    for (const auto& [c, expected] :
         {std::pair{0, 0.25 * 8 + 4}, {1, 0.25 * 8 + 4}, {2, 0.5 * 8 + 8}, {3, 0.5 * 8 + 8}})
        EXPECT_NEAR(double(transmittance[c]) * 8 + double(added[c]), expected, 1e-5) << c;
    // RGB: the whole band
    const AirPath gray = AirPath::parse("#% bands 8 10 12\n1000 .5 4 .25 2\n", "air", {});
    EXPECT_NEAR(through(gray, 0, 1000, 8), 0.375 * 8 + 6, 1e-5);
}

TEST(AirPath, RefusesBadFiles) {
    const auto refusal = [](const std::string& text, const Channels& channels = {}) {
        return test::error_of([&] { AirPath::parse(text, "air", channels); });
    };
    const auto expect = [&](const std::string& text, const std::string& start) {
        EXPECT_TRUE(refusal(text).starts_with(start)) << refusal(text);
    };
    expect("", "air: no rows");
    expect("# nothing\n0 1 0\n", "air:2: no rows");
    expect("10 .9\n", "air:1: expected 3 columns, found 2");
    expect("10 nan 1\n", "air:1: \"nan\" is not a number");
    expect("10 .9 1\n5 .8 2\n", "air:2: distance 5 does not come after 10");
    expect("10 .5 1\n20 .8 2\n", "air:2: transmittance 0.8 is larger");
    expect("10 1.5 1\n", "air:1: transmittance 1.5");
    expect("10 0 1\n", "air:1: transmittance 0");
    expect("10 .9 -1\n", "air:1: path radiance -1 is negative");
    expect("10 1 1\n", "air:1: path radiance without absorption");
    expect("10 .5 10\n20 .4 .5\n", "air:2: path radiance 0.5 is smaller than nearer by");
    expect("0 .9 0\n", "air:1: at distance 0");
    expect("#% bands 12 8\n10 .9 1\n", "air:1: edges of bands");
    expect("#% band 8 12\n10 .9 1\n", "air:1: unknown directive");
    expect("10 .9 1\n#% bands 8 12\n", "air:2: bands must be stated once");
    EXPECT_TRUE(refusal("#% bands 8 12\n10 .9 1\n", Channels::spectral(4, 8000, 14000))
                    .starts_with("air: bands of 8-12 um do not cover channel 0"));
}

}  // namespace
}  // namespace infra
