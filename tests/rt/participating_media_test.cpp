// Media that rays travel in: extinction, light of listed sources scattered once, and how volumes nest.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rt/volume/henyey_greenstein.h"
#include "traced_scene.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

const std::string wall =
    "void glow bright 0 0 4 1 1 1 0 bright polygon wall 0 0 12 -9 9 -9 9 9 -9 9 9 9 -9 9 9\n";
const std::string grey_wall =
    "void plastic dark 0 0 5 0 0 0 0 0 dark polygon wall 0 0 12 -9 9 -9 9 9 -9 9 9 9 -9 9 9\n";

RenderSettings in_haze(float extinction, float albedo, double eccentricity = 0, double step = 0) {
    RenderSettings settings;
    for (int c = 0; c < 3; ++c) {
        settings.extinction[c] = extinction;
        settings.scattering_albedo[c] = albedo;
    }
    settings.scattering_eccentricity = eccentricity;
    settings.medium_step = step;
    return settings;
}

float radiance_along_y(const std::string& text, const RenderSettings& settings = {}) {
    return test::TracedScene(text, settings).radiance({0, 0, 0}, {0, 1, 0})[0];
}

TEST(Medium, GlobalOneDimsWithDistance) {
    EXPECT_NEAR(radiance_along_y(wall, in_haze(0.2f, 0)), std::exp(-0.2 * 9), 1e-5);
    EXPECT_EQ(radiance_along_y(test::surrounding(1), in_haze(0.2f, 0)), 0.0f)
        << "nothing comes from infinity";
    EXPECT_EQ(radiance_along_y(wall, in_haze(-0.2f, 0)), 1.0f) << "less than none is none";
}

TEST(Medium, ScattersTheAmbientValueIntoRays) {
    RenderSettings settings = in_haze(0.2f, 0.5f);
    settings.ambient_value[0] = 3;
    const double left = std::exp(-0.2 * 9);
    EXPECT_NEAR(radiance_along_y(wall, settings), left + 0.5 * 3 * (1 - left), 1e-5);
}

TEST(Medium, OfAShadowRayOnlyAbsorbs) {
    const std::string text =
        "void light lum 0 0 3 100 100 100 lum sphere lamp 0 0 4 0 0 5 .1\n"
        "void plastic white 0 0 5 1 1 1 0 0 white ring floor 0 0 8 0 0 0 0 0 1 0 5\n";
    const auto lit = [&](const RenderSettings& settings) {
        return static_cast<double>(test::TracedScene(text, settings).radiance({0, 0, 1e-3}, {0, 0, -1})[0]);
    };
    EXPECT_NEAR(lit(in_haze(0.1f, 0.75f)) / lit({}), std::exp(-0.1 * 0.25 * 4.9), 1e-3);
}

TEST(Mist, AddsToWhatIsThere) {
    const std::string balls =
        "void mist a 0 0 3 .3 .3 .3 a sphere big 0 0 4 0 5 0 3\n"
        "void mist b 0 0 3 .1 .1 .1 b sphere small 0 0 4 0 5 0 1\n";
    EXPECT_NEAR(radiance_along_y(wall + balls), std::exp(-(0.3 * 6 + 0.1 * 2)), 1e-5);
    EXPECT_NEAR(radiance_along_y(wall + balls, in_haze(0.05f, 0)), std::exp(-(0.3 * 6 + 0.1 * 2 + 0.05 * 9)),
                1e-5);
}

TEST(Mist, HasPatternsThatMultiplyItsExtinction) {
    const std::string ball =
        "void brightfunc half 2 .5 . 0 0 half mist a 0 0 3 .4 .4 .4 a sphere big 0 0 4 0 5 0 3\n";
    EXPECT_NEAR(radiance_along_y(wall + ball), std::exp(-0.2 * 6), 1e-5);
}

TEST(Mist, IsNoticedByAnEyeInsideIfItNamesSources) {
    const std::string lamp = "void light lum 0 0 3 1 1 1 lum sphere lamp 0 0 4 0 0 50 .1\n";
    const std::string ball = " 0 6 .3 .3 .3 0 0 0 a sphere big 0 0 4 0 0 0 3\n";
    EXPECT_EQ(radiance_along_y(wall + lamp + "void mist a 0" + ball), 1.0f);
    EXPECT_NEAR(radiance_along_y(wall + lamp + "void mist a 1 lamp" + ball), std::exp(-0.3 * 3), 1e-5);
}

/// A beam of parallel light across the ray at y = 3..5; its disk is small enough for one direction.
const std::string sun = "void light lum 0 0 3 1e5 1e5 1e5 lum source sun 0 0 4 0 0 1 .5\n";
const double sun_irradiance = 1e5 * 2 * pi * (1 - std::cos(0.25 * pi / 180));

/// Mist between the planes y = 3 and y = 5.
std::string layer(const std::string& sources, const std::string& numbers) {
    return "void mist m " + sources + " 0 " + numbers +
           " m ring near 0 0 8 0 3 0 0 -1 0 0 900 m ring far 0 0 8 0 5 0 0 1 0 0 900\n";
}

// Along the ray: integral of s P E exp(-e y) over the layer. Without absorption the beam loses nothing.
TEST(Mist, ScattersABeamOnce) {
    const std::string text = grey_wall + sun + layer("1 sun", "7 .2 .2 .2 1 1 1 .4");
    RenderSettings settings;
    settings.medium_step = 0.25;
    test::TracedScene scene(text, settings);
    const auto seen = scene.mean_radiance(4000, Vec3{0, 0, 0}, Vec3{0, 1, 0});
    const double phase = henyey_greenstein(0.4, 0);
    test::expect_close(seen, sun_irradiance * phase * (1 - std::exp(-0.2 * 2)), 1e-3);
}

TEST(Mist, ScattersNoSourceThatItDoesNotName) {
    EXPECT_EQ(radiance_along_y(grey_wall + sun + layer("0", "7 .2 .2 .2 1 1 1 .4")), 0.0f);
    EXPECT_GT(radiance_along_y(grey_wall + sun + layer("1 sun", "7 .2 .2 .2 1 1 1 .4")), 0.0f);
}

TEST(Mist, TakesAlbedoAndEccentricityFromTheOptionsWhereItHasNone) {
    const std::string text = grey_wall + sun + layer("1 sun", "3 .2 .2 .2");
    EXPECT_EQ(radiance_along_y(text), 0.0f) << "-ma is 0";
    test::TracedScene scene(text, in_haze(0, 1, 0.4, 0.25));
    const auto seen = scene.mean_radiance(4000, Vec3{0, 0, 0}, Vec3{0, 1, 0});
    test::expect_close(seen, sun_irradiance * henyey_greenstein(0.4, 0) * (1 - std::exp(-0.2 * 2)), 1e-3);
}

// Seen from the side, a spotlight's cone is a cylinder of light: 2 R long where the ray crosses it.
TEST(Mist, ShowsTheConeOfASpotlight) {
    const std::string spot =
        "void spotlight lum 0 0 7 1e4 1e4 1e4 20 0 0 -10 lum ring lamp 0 0 8 0 5 10 0 0 -1 0 .05\n";
    const std::string ball = "void mist m 1 lamp 0 6 .01 .01 .01 1 1 1 m sphere puff 0 0 4 0 5 0 4\n";
    RenderSettings settings;
    settings.medium_step = 0.5;
    test::TracedScene scene(grey_wall + spot + ball, settings);
    const auto seen = scene.mean_radiance(20000, Vec3{0, 0, 0}, Vec3{0, 1, 0});
    // Radiance L of the disk A, which a focus 10 units behind spreads: E = L A cos / (d + 10)^2.
    double expected = 0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
        const double y = 1 + 8 * (i + 0.5) / steps, across = y - 5, d2 = across * across + 100;
        const double cosine = 10 / std::sqrt(d2);
        if (cosine < std::cos(10 * pi / 180)) continue;
        const double spread = std::sqrt(d2) + 10;
        expected += 1e4 * pi * 0.0025 * cosine / (spread * spread) / (4 * pi) * 0.01 *
                    std::exp(-0.01 * (y - 1)) * 8 / steps;
    }
    test::expect_close(seen, expected, 2e-3);
}

TEST(HenyeyGreenstein, IsADensityWithItsEccentricityAsMeanCosine) {
    for (const double g : {0.0, 0.3, 0.9}) {
        double total = 0, mean = 0;
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
            const double cosine = -1 + 2 * (i + 0.5) / steps;
            const double weight = henyey_greenstein(g, cosine) * 2 * pi * 2 / steps;
            total += weight;
            mean += weight * cosine;
        }
        EXPECT_NEAR(total, 1, 1e-5);
        EXPECT_NEAR(mean, g, 1e-5);
    }
}

TEST(Mist, WarnsOfNamesThatAreNoSources) {
    test::TracedScene scene(sun + layer("3 sun wall sun", "3 .2 .2 .2"));
    const auto& warnings = scene.compiled().warnings();
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_NE(warnings[0].find("unknown source \"wall\""), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find("duplicate source \"sun\""), std::string::npos) << warnings[1];
}

TEST(Mist, FindsAnImageOfASourceByTheNamesOfMirrorAndSource) {
    const std::string lamps =
        "void light lum 0 0 3 100 100 100 lum sphere lamp 0 0 4 0 0 5 .1\n"
        "void mirror glass 0 0 3 1 1 1 glass polygon pane 0 0 12 9 9 0 -9 9 0 -9 -9 0 9 -9 0\n";
    EXPECT_TRUE(test::TracedScene(lamps + layer("1 pane>lamp", "3 .2 .2 .2")).compiled().warnings().empty());
    EXPECT_EQ(test::TracedScene(lamps + layer("1 lamp>pane", "3 .2 .2 .2")).compiled().warnings().size(), 1u);
}

}  // namespace
}  // namespace infra
