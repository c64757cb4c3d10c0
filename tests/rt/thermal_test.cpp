// The thermal material: Planck's radiance, Kirchhoff's emissivity, patterns of temperature, channels.
#include <gtest/gtest.h>

#include <vector>

#include "common/planck/planck.h"
#include "common/test_files.h"
#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::degree;
using test::words;

const test::RaySpec from_above = test::view_of_plate(30 * degree, 0.4);
const test::RaySpec from_below{{0.1, 0.2, -3}, {0, 0, 1}};
constexpr double single = 2e-7;  // relative, of a float

std::vector<double> seen(const std::string& text, const test::RaySpec& view = from_above,
                         const Channels& channels = {}, const RenderSettings& settings = {}) {
    test::TracedScene scene(text + test::plate, settings, channels);
    const Spectrum value = scene.radiance(view.origin, view.direction);
    std::vector<double> result;
    for (int c = 0; c < value.channels(); ++c) result.push_back(double(value[c]));
    return result;
}

void expect_values(const std::vector<double>& values, const std::vector<double>& expected, double bar) {
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t c = 0; c < values.size(); ++c)
        EXPECT_NEAR(values[c], expected[c], bar * expected[c]) << "channel " << c;
}

TEST(Thermal, WithoutAMaterialIsBlackFromBothSides) {
    const std::vector<double> expected(3, band_radiance(300, 8, 12));
    for (const char* text : {"void thermal m 0 0 3 300 8 12", "void thermal m 1 void 0 3 300 8 12"})
        for (const test::RaySpec& view : {from_above, from_below})
            expect_values(seen(text, view), expected, single);
}

TEST(Thermal, EmitsWhatItsMaterialDoesNotReflect) {
    const double black = band_radiance(300, 8, 12);
    expect_values(seen("void plastic skin 0 0 5 .1 .3 .6 0 0 void thermal m 1 skin 0 3 300 8 12"),
                  {0.9 * black, 0.7 * black, 0.4 * black}, 1e-6);
    expect_values(seen("void plastic a 0 0 5 .2 .2 .2 0 0 void plastic b 0 0 5 .8 .8 .8 0 0\n"
                       "void mixfunc skin 4 a b .25 . 0 0 void thermal m 1 skin 0 3 300 8 12"),
                  std::vector<double>(3, (0.25 * 0.8 + 0.75 * 0.2) * black), 1e-6);
    // A share that lets the ray pass emits nothing
    expect_values(seen("void plastic a 0 0 5 .2 .2 .2 0 0\n"
                       "void mixfunc skin 4 a void .25 . 0 0 void thermal m 1 skin 0 3 300 8 12"),
                  std::vector<double>(3, 0.25 * 0.8 * black), 1e-6);
    // Patterns of the material scale what it reflects
    expect_values(seen("void brightfunc half 2 .5 . 0 0 half plastic skin 0 0 5 .6 .6 .6 0 0\n"
                       "void thermal m 1 skin 0 3 300 8 12"),
                  std::vector<double>(3, 0.7 * black), 1e-6);
}

// Closed forms of the emissivity at an angle: 1 less reflectance and transmittance.
TEST(Thermal, EmissivityByAngle) {
    const double black = band_radiance(300, 8, 12);
    for (const double angle : {0.0, 40.0, 70.0, 85.0}) {
        const test::RaySpec view = test::view_of_plate(angle * degree, 0.4);
        const double c = std::cos(angle * degree);
        const double fresnel = std::exp(-5.85 * c) - 0.00287989916;
        const double specular = 0.1 + fresnel * 0.9;
        expect_values(seen("void plastic skin 0 0 5 .4 .4 .4 .1 0 void thermal m 1 skin 0 3 300 8 12", view),
                      std::vector<double>(3, (1 - specular - 0.4 * (1 - specular)) * black), 1e-5);
        expect_values(
            seen("void trans skin 0 0 7 .5 .5 .5 0 0 .6 .5 void thermal m 1 skin 0 3 300 8 12", view),
            std::vector<double>(3, 0.5 * black), 1e-5);
    }
}

// A clear pane absorbs nothing, so it emits nothing.
TEST(Thermal, ClearGlassEmitsNothing) {
    for (const double angle : {0.0, 60.0, 80.0}) {
        const test::RaySpec view = test::view_of_plate(angle * degree, 0.4);
        const auto value = seen("void glass pane 0 0 3 1 1 1 void thermal m 1 pane 0 3 300 8 12", view);
        EXPECT_NEAR(value[0], 0, 1e-4);
    }
}

TEST(Thermal, TableEmitsByItsDirectionalReflectance) {
    const test::TemporaryFolder folder;
    const double black = band_radiance(300, 3, 5);
    for (const auto& file : test::write_tables(folder))
        for (const double angle : {0.0, 33.0, 71.0}) {
            test::TracedScene scene("void nrlbrdf skin 1 " + file.path +
                                        " 0 5 1 1 1 1 .3 void thermal m 1 skin 0 3 300 3 5" + test::plate,
                                    test::path_settings());
            const auto value = test::seen(scene, test::view_of_plate(angle * degree, 0.4), 20000);
            const double expected = black * (1 - file.table->reflectance_dh(std::cos(angle * degree)));
            test::expect_close(value, expected, 1e-3);
        }
}

TEST(Thermal, StatedEmissivityReplacesTheDerivedOne) {
    const double black = band_radiance(300, 8, 12);
    const std::string skin = "void plastic skin 0 0 5 .6 .6 .6 0 0\n";
    expect_values(seen(skin + "void thermal m 1 skin 0 4 300 8 12 .25"), std::vector<double>(3, 0.25 * black),
                  single);
    expect_values(seen("void thermal m 0 0 4 300 8 12 .25"), std::vector<double>(3, 0.25 * black), single);
    const auto reflecting = seen(skin + "void thermal m 1 skin 0 4 300 8 12 .25\n" + test::surrounding(10),
                                 from_above, {}, test::bounce_settings(1));
    expect_values(reflecting, std::vector<double>(3, 0.25 * black + 0.6 * 10), 1e-6);
}

TEST(Thermal, PatternsMultiplyTheTemperature) {
    expect_values(seen("void brightfunc warmer 2 1.1 . 0 0 warmer thermal m 0 0 3 300 8 12"),
                  std::vector<double>(3, band_radiance(330, 8, 12)), 1e-6);
    expect_values(seen("void brightfunc kelvin 2 280+Px . 0 0 kelvin thermal m 0 0 3 1 8 12", from_below),
                  std::vector<double>(3, band_radiance(280.1, 8, 12)), 1e-6);
    expect_values(seen("void colorfunc kelvin 4 280 290 300 . 0 0 kelvin thermal m 0 0 3 1 8 12"),
                  {band_radiance(280, 8, 12), band_radiance(290, 8, 12), band_radiance(300, 8, 12)}, 1e-6);
    // ... and nothing of the material
    expect_values(seen("void brightfunc warmer 2 1.1 . 0 0 void plastic skin 0 0 5 .5 .5 .5 0 0\n"
                       "warmer thermal m 1 skin 0 3 300 8 12\n" +
                           test::surrounding(10),
                       from_above, {}, test::bounce_settings(1)),
                  std::vector<double>(3, 0.5 * band_radiance(330, 8, 12) + 5), 1e-6);
}

TEST(Thermal, TemperaturesOfZeroAreCountedAndDark) {
    test::TracedScene scene("void brightfunc cold 2 -Px . 0 0 cold thermal m 0 0 3 1 8 12" + test::plate);
    EXPECT_EQ(scene.radiance(from_below.origin, from_below.direction)[0], 0.0f);
    EXPECT_EQ(scene.tracer().bad_temperatures(), 1u);

    test::TracedScene beyond("void brightfunc hot 2 1e39 . 0 0 hot thermal m 0 0 3 1 8 12" + test::plate);
    EXPECT_EQ(beyond.radiance(from_below.origin, from_below.direction)[0], 0.0f);
    EXPECT_EQ(beyond.tracer().bad_temperatures(), 1u);
}

std::vector<std::string> warnings(const std::string& text, const Channels& channels = {}) {
    return test::TracedScene(text + test::plate, {}, channels).compiled().warnings();
}

TEST(Thermal, WarnsOfBandsThatDoNotMeetTheChannels) {
    const std::string text = "void thermal m 0 0 3 300 8 12";
    EXPECT_EQ(warnings(text, Channels::spectral(4, 8000, 12000)), std::vector<std::string>{});
    EXPECT_EQ(warnings(text, Channels::spectral(4, 9000, 11000)), std::vector<std::string>{});
    EXPECT_EQ(
        warnings(text, Channels::spectral(4, 3000, 5000)),
        std::vector<std::string>{"thermal surfaces of 8-12 um are dark in channels of 3-5 um (-cw is in "
                                 "nanometres)"});
    EXPECT_EQ(
        warnings(text, Channels::spectral(4, 8000, 14000)),
        std::vector<std::string>{"thermal surfaces of 8-12 um are dark in a part of the channels' 8-14 um"});
}

TEST(Thermal, WarnsOfTwoBandsInOneColorAndOfCelsius) {
    const std::string two =
        "void thermal other 0 0 3 300 3 5 other sphere s 0 0 4 9 9 9 1\n"
        "void thermal m 0 0 3 300 8 12";
    ASSERT_EQ(warnings(two).size(), 1u);
    EXPECT_TRUE(warnings(two)[0].starts_with("thermal surfaces of 3-5 um and of 8-12 um in one rendering"));
    ASSERT_EQ(warnings("void thermal m 0 0 3 20 8 12").size(), 1u);
    EXPECT_NE(warnings("void thermal m 0 0 3 20 8 12")[0].find("degrees Celsius?"), std::string::npos);
}

TEST(Thermal, TellsTheBandOfTheScene) {
    EXPECT_EQ(test::TracedScene("void thermal m 0 0 3 300 8 12" + test::plate).compiled().band(),
              (std::pair{8.0, 12.0}));
    EXPECT_FALSE(test::TracedScene("void emissive m 0 0 3 1 1 1" + test::plate).compiled().band());
}

// A channel's value is N times the radiance in its part of the band; the mean is the band's.
TEST(Thermal, ChannelsShareTheBand) {
    const Channels channels = Channels::spectral(8, 8000, 12000);
    std::vector<double> expected;
    for (int c = 0; c < 8; ++c) expected.push_back(8 * band_radiance(300, 11.5 - 0.5 * c, 12 - 0.5 * c));
    expect_values(seen("void thermal m 0 0 3 300 8 12", from_above, channels), expected, single);

    // A range wider than the band: what lies outside is not the surface's business
    const std::vector<double> wide =
        seen("void thermal m 0 0 3 300 8 12", from_above, Channels::spectral(4, 7000, 13000));
    expect_values(wide,
                  {4 * band_radiance(300, 11.5, 12), 4 * band_radiance(300, 10, 11.5),
                   4 * band_radiance(300, 8.5, 10), 4 * band_radiance(300, 8, 8.5)},
                  single);
    EXPECT_EQ(seen("void thermal m 0 0 3 300 8 12", from_above, Channels::spectral(3, 3000, 5000)),
              (std::vector<double>{0, 0, 0}));
}

// Several rays of a rough lobe weigh less than 1 in the mean: what they lose is emitted, without noise.
TEST(Thermal, RoughSurfacesEmitTheSameForEachRay) {
    RenderSettings settings = test::path_settings();
    settings.min_weight = 1e-6;
    for (const double samples : {1.0, 2.0, 8.0, 64.0})
        for (const double angle : {0.0, 50.0, 80.0}) {
            settings.specular_samples = samples;
            test::TracedScene alone(
                "void metal skin 0 0 5 .9 .9 .9 .7 .2 void thermal m 1 skin 0 3 300 8 12" + test::plate,
                settings);
            const auto emission = test::seen(alone, test::view_of_plate(angle * degree, 0.4), 50);
            EXPECT_LT(emission.error, 1e-6);
            EXPECT_GT(emission.mean, 0);

            test::TracedScene furnace(
                "void metal skin 0 0 5 .9 .9 .9 .7 .2 void thermal m 1 skin 0 3 300 8 12\n"
                "void thermal black 0 0 3 300 8 12 black bubble room 0 0 4 0 0 0 9" +
                    test::plate,
                settings);
            test::expect_close(test::seen(furnace, test::view_of_plate(angle * degree, 0.4), 50000),
                               band_radiance(300, 8, 12), 2e-3);
        }
}

TEST(Thermal, APatternBeforeItCountsToo) {
    const auto value = seen("void thermal hot 0 0 3 1 8 12 hot brightfunc m 2 300 . 0 0");
    EXPECT_NEAR(value[0], band_radiance(300, 8, 12), 1e-4);
}

// Without lights a picture of it is no mistake.
TEST(Thermal, NeedsNoLight) {
    const auto warnings = [](const std::string& material) {
        return test::TracedScene(material + test::plate).compiled().warnings().size();
    };
    EXPECT_EQ(warnings("void thermal m 0 0 3 300 8 12"), 0u);
    EXPECT_EQ(warnings("void emissive m 0 0 3 1 1 1"), 0u);
    EXPECT_EQ(warnings("void plastic m 0 0 5 1 1 1 0 0"), 1u);
}

TEST(Thermal, IsFoundByMirrorsAndIndirectRaysNotByDirectSampling) {
    const double black = band_radiance(300, 8, 12);
    const std::string ceiling = "void thermal hot 0 0 3 300 8 12 hot bubble room 0 0 4 0 0 0 9\n";
    const double fresnel = std::exp(-5.85 * std::cos(30 * degree)) - 0.00287989916;
    expect_values(seen(ceiling + "void metal m 0 0 5 .5 .5 .5 1 0"),
                  std::vector<double>(3, (0.5 + 0.5 * fresnel) * black), 1e-5);
    EXPECT_EQ(seen(ceiling + "void plastic m 0 0 5 .5 .5 .5 0 0")[0], 0);  // -ab 0
    expect_values(
        seen(ceiling + "void plastic m 0 0 5 .5 .5 .5 0 0", from_above, {}, test::bounce_settings(1)),
        std::vector<double>(3, 0.5 * black), 1e-6);
}

}  // namespace
}  // namespace infra
