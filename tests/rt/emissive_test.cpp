// The emissive material: what it sends out by itself, what it lets its material reflect, and when it is a
// light source.
#include <gtest/gtest.h>

#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
using test::words;

const std::string half = "void brightfunc half 2 .5 . 0 0\n";
const test::RaySpec from_above = test::view_of_plate(30 * degree, 0.4);
const test::RaySpec from_below{{0.1, 0.2, -3}, {0, 0, 1}};

// First channel of the plate in a surrounding of radiance 10.
double seen_in_surrounding(const std::string& material, const test::RaySpec& view = from_above) {
    test::TracedScene scene(material + test::plate + test::surrounding(10), test::bounce_settings(1));
    return static_cast<double>(scene.radiance(view.origin, view.direction)[0]);
}

TEST(Emissive, IsSeenFromBothSidesInItsOwnColor) {
    test::TracedScene scene("void emissive m 0 0 3 2 3 4" + test::plate);
    for (const test::RaySpec& view : {from_above, from_below}) {
        const Spectrum value = scene.radiance(view.origin, view.direction);
        EXPECT_EQ(value[0], 2.0f);
        EXPECT_EQ(value[1], 3.0f);
        EXPECT_EQ(value[2], 4.0f);
    }
}

TEST(Emissive, AddsToWhatItsMaterialReflects) {
    const std::string skin = "void plastic skin 0 0 5 .6 .6 .6 0 0\n";
    EXPECT_NEAR(seen_in_surrounding(skin + "void emissive m 1 skin 0 3 2 2 2"), 2 + 0.6 * 10, 1e-5);
    EXPECT_NEAR(seen_in_surrounding(skin + "void emissive m 1 skin 0 3 2 2 2", from_below), 2 + 0.6 * 10,
                1e-5);
}

TEST(Emissive, IsBlackWithoutAMaterial) {
    EXPECT_EQ(seen_in_surrounding("void emissive m 0 0 3 2 2 2"), 2);
    EXPECT_EQ(seen_in_surrounding("void emissive m 1 void 0 3 2 2 2"), 2);
}

TEST(Emissive, PatternsOnItScaleTheEmissionOnly) {
    EXPECT_NEAR(
        seen_in_surrounding(half + "void plastic skin 0 0 5 .6 .6 .6 0 0 half emissive m 1 skin 0 3 2 2 2"),
        0.5 * 2 + 0.6 * 10, 1e-5);
}

TEST(Emissive, PatternsOfItsMaterialScaleTheReflectionOnly) {
    EXPECT_NEAR(
        seen_in_surrounding(half + "half plastic skin 0 0 5 .6 .6 .6 0 0 void emissive m 1 skin 0 3 2 2 2"),
        2 + 0.5 * 0.6 * 10, 1e-5);
}

TEST(Emissive, WrapsMixturesMirrorsAndSheets) {
    EXPECT_NEAR(seen_in_surrounding("void plastic a 0 0 5 .2 .2 .2 0 0 void plastic b 0 0 5 .8 .8 .8 0 0\n"
                                    "void mixfunc skin 4 a b .25 . 0 0 void emissive m 1 skin 0 3 2 2 2"),
                2 + (0.25 * 0.2 + 0.75 * 0.8) * 10, 1e-5);
    EXPECT_NEAR(seen_in_surrounding("void metal skin 0 0 5 .5 .5 .5 1 .2 void emissive m 1 skin 0 3 2 2 2"),
                2 + 5, 1e-5);
    EXPECT_NEAR(
        seen_in_surrounding("void trans skin 0 0 7 .6 .6 .6 0 0 .5 .5 void emissive m 1 skin 0 3 2 2 2"),
        2 + 6, 1e-5);
    EXPECT_NEAR(seen_in_surrounding("void plastic p 0 0 5 .5 .5 .5 0 0 void emissive skin 1 p 0 3 1 1 1\n"
                                    "void emissive m 1 skin 0 3 2 2 2"),
                3 + 5, 1e-5);
}

// A floor below a panel that emits and reflects, in a surrounding; sampled as a light source or met by
// chance.
test::Estimate floor_radiance(const std::string& floor, const std::string& emissive_reach) {
    RenderSettings settings = test::bounce_settings(64);
    settings.specular_samples =
        8;  // more than one lobe sample: their mean is that of the lobe light sources see
    settings.source_jitter = 1;
    test::TracedScene scene(
        words(floor, test::plate, "void plastic skin 0 0 5 .5 .5 .5 0 0\nvoid emissive panel 1 skin 0 4",
              "5 5 5", emissive_reach, "\npanel polygon p 0 0 12 -1.2 -1 1 -1.2 .4 1 0 .4 1 0 -1 1\n",
              test::surrounding(3)),
        settings);
    return test::seen(scene, test::view_of_plate(50 * degree, 0.4), 3000);
}

TEST(Emissive, CountsOnceWhateverItsReach) {
    for (const char* floor : {"void plastic m 0 0 5 .5 .5 .5 0 0", "void metal m 0 0 5 .6 .6 .6 .9 .2"}) {
        SCOPED_TRACE(floor);
        const test::Estimate met = floor_radiance(floor, "0"), sampled = floor_radiance(floor, "100");
        EXPECT_LT(met.error, 0.01 * met.mean);
        test::expect_same(met, sampled);
        test::expect_same(met, floor_radiance(floor, ".4"));  // nearer than the floor
    }
}

// Radiance of a diffuse floor under the sun with a sheet of the modifier "sheet" in between.
double floor_in_shade(const std::string& sheet) {
    test::TracedScene scene("void plastic m 0 0 5 1 1 1 0 0" + test::plate + sheet +
                            "\nsheet ring r 0 0 8 0 0 1 0 0 1 0 5\n"
                            "void light sun 0 0 3 1000 1000 1000 sun source s 0 0 4 0 0 1 .5\n");
    return static_cast<double>(scene.radiance({0.9, 0, 0.5}, normalize(Vec3{-0.9, 0, -0.5}))[0]);
}

TEST(Emissive, ShadowsAsItsMaterialDoes) {
    EXPECT_EQ(floor_in_shade("void emissive sheet 0 0 3 1 1 1"), 0);
    EXPECT_EQ(floor_in_shade("void plastic skin 0 0 5 .5 .5 .5 0 0 void emissive sheet 1 skin 0 3 1 1 1"), 0);
    const std::string clear = "void glass pane 0 0 3 .9 .9 .9 ";
    const double through = floor_in_shade(clear + "void alias sheet pane");
    EXPECT_GT(through, 0);
    EXPECT_EQ(floor_in_shade(clear + "void emissive sheet 1 pane 0 3 1 1 1"), through);
}

}  // namespace
}  // namespace infra
