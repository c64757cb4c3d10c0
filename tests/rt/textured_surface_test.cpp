// Textures on the materials that are ours: they bend a table's lobe once, never below the true surface, and
// leave emission and the reflecting material apart; and on rough lobes that they turn below the surface.
#include <gtest/gtest.h>

#include "common/planck/planck.h"
#include "lobe_statistics.h"
#include "rt/lobes/ward.h"
#include "rt/materials/emissive_material.h"
#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::words;

const std::string bump = "void texfunc bump 4 .4 0 0 . 0 0\n";
const std::string plate = "m polygon plate 0 0 12 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n";
const Vec3 slanted = normalize(Vec3{0.5, 0, -1});

double mean_radiance(const std::string& text) {
    test::TracedScene scene(text, test::bounce_settings(64));
    double sum = 0;
    for (int i = 0; i < 4000; ++i) sum += scene.radiance({-1, 0, 2}, slanted)[0];
    return sum / 4000;
}

TEST(Texture, BendsATableWithEmissionAsOneWithout) {
    const test::TemporaryFolder folder;
    const auto tables = test::write_tables(folder);
    const std::string sky = "void glow g 0 0 4 1 1 1 0\ng source up 0 0 4 1 0 1 60\n";
    const std::string plain = "bump nrlbrdf m 1 " + tables.back().path + " 0 5 1 1 1 16 .2\n";
    const std::string emitting = "bump nrlbrdf m 1 " + tables.back().path + " 0 8 1 1 1 16 .2 0 0 0\n";
    const double expected = mean_radiance(bump + plain + plate + sky);
    EXPECT_NEAR(mean_radiance(bump + emitting + plate + sky), expected, 0.01 * expected);
}

TEST(Texture, LetsNoTableLobeLookBelowTheSurface) {
    const test::TemporaryFolder folder;
    const auto tables = test::write_tables(folder);
    const std::string below = "void glow g 0 0 4 1 1 1 0\ng source down 0 0 4 0 0 -1 179.9\n";
    for (const auto& table : tables)
        EXPECT_EQ(
            mean_radiance(bump + "bump nrlbrdf m 1 " + table.path + " 0 5 1 1 1 16 .2\n" + plate + below), 0);
}

// Turned so far that most of the lobe goes below the surface: RADIANCE 6.1 draws ten times for each ray.
const std::string steep = "void texfunc steep 4 -1 .3 0 . 0 0\n";
const Vec3 steep_normal = normalize(Vec3{-1, 0.3, 1});
const test::RaySpec from_x = test::view_of_plate(20 * test::degree, 0);

TEST(Texture, LeavesDarkWhatTenDrawsDoNotFind) {
    const double roughness = 0.2, reflectance = 0.8;
    WardSetting setting{from_x.direction, frame_around(steep_normal), {0, 0, 1}, {roughness, roughness}, 1,
                        nullptr};
    const WardReflection lobe(Spectrum(3, 1), setting, 0);
    const double accepted = test::hemisphere_integral([&](const Vec3& wi) { return lobe.pdf(wi); }, 1);
    const std::string metal = words("steep metal m 0 0 5 .8 .8 .8 1", roughness, "\n");
    test::TracedScene scene(steep + metal + test::plate + test::surrounding(1), test::bounce_settings(1));
    const double found = 1 - std::pow(1 - accepted, 10);
    ASSERT_NEAR(found, 0.57, 0.02);  // RADIANCE 6.1: 0.566(8)
    test::expect_close(test::seen(scene, from_x, 40'000), reflectance * found, 0.01);
}

// Light of a round patch of sky, of half angle a, in direction d: L sin^2(a) times d's component along the
// normal, which for many rays is n + sin(turn) t, as in RADIANCE 6.1 from 43 rays on: 0.1171(2) and 0.0940(3)
// here (with fewer it forgets the texture). Few rays are those over the turned facet, of which the surface
// hides a part.
TEST(Texture, TurnsIndirectLight) {
    const double turn = std::atan(0.5), patch = 20 * test::degree;
    const std::string white = "void texfunc turned 4 .5 0 0 . 0 0 turned plastic m 0 0 5 1 1 1 0 0\n";
    const auto seen_under_sky = [&](const Vec3& d, int divisions, double super_samples, int rays) {
        RenderSettings settings = test::bounce_settings(divisions);
        settings.ambient_super_samples = super_samples;
        test::TracedScene scene(
            white + test::plate +
                words("void glow g 0 0 4 1 1 1 0\ng source patch 0 0 4", d.x, d.y, d.z, "40\n"),
            settings);
        return test::seen(scene, test::view_of_plate(0, 0), rays);
    };
    const double size = std::sin(patch) * std::sin(patch);
    for (const Vec3& d : {Vec3{0, 0, 1}, test::direction(65 * test::degree, 0.3)}) {
        const double many = size * (d.z + std::sin(turn) * d.x);
        test::expect_close(seen_under_sky(d, 1024, 0, 100), many, 0.01);
        // Extra rays go where neighbours differ, which has a bias of its own, with a texture or without
        EXPECT_NEAR(seen_under_sky(d, 256, 128, 300).mean, many, 0.03 * many);
        const double few = size * (std::cos(turn) * d.z + std::sin(turn) * d.x) * 2 / (1 + std::cos(turn));
        test::expect_close(seen_under_sky(d, 16, 0, 10'000), few, 0.02);
    }
}

TEST(Texture, LeavesEvenLightEven) {
    for (const int divisions : {1, 16, 64, 1024})
        for (const double turn : {0.1, 0.5, 3.0}) {
            test::TracedScene scene(words("void texfunc turned 4", turn, turn, "0 . 0 0",
                                          "turned trans m 0 0 7 .8 .8 .8 0 0 .5 0\n") +
                                        test::plate + test::surrounding(1),
                                    test::bounce_settings(divisions));
            test::expect_close(test::seen(scene, test::view_of_plate(0, 0), 20), 0.8, 1e-4);
        }
}

// Kirchhoff: what these draws don't find is emitted. For one ray and for several.
TEST(Texture, LeavesThermalSurfacesInEquilibrium) {
    const double room = band_radiance(300, 8, 12);
    for (const char* skin :
         {"metal skin 0 0 5 .6 .7 .8 .9 .2", "plastic skin 0 0 5 .3 .3 .3 .3 .15",
          "metal2 skin 4 1 0 0 . 0 6 .6 .7 .8 .9 .2 .1", "ashik2 skin 4 1 0 0 . 0 8 .1 .1 .1 .6 .6 .6 20 60",
          "trans skin 0 0 7 .8 .8 .8 .2 .15 .9 .9"})
        for (const double samples : {1.0, 16.0})
            for (const char* texture : {"steep", "bump"}) {
                SCOPED_TRACE(words(texture, skin, "samples", samples));
                RenderSettings settings = test::bounce_settings(1);
                settings.specular_samples = samples;
                test::TracedScene scene(steep + bump +
                                            words(texture, skin, "void thermal m 1 skin 0 3 300 8 12") +
                                            test::plate + test::surrounding(room),
                                        settings);
                test::expect_close(test::seen(scene, from_x, 4000), room, 1e-3);
            }
}

TEST(Emissive, GivesItsLightFromWithinAMixtureToo) {
    const std::string text =
        "void plastic dark 0 0 5 0 0 0 0 0\n"
        "void emissive hot 0 0 4 10 10 10 100\n"
        "void mixfunc m 4 hot dark .5 . 0 0\n"
        "m polygon panel 0 0 12 -1 -1 2 -1 1 2 1 1 2 1 -1 2\n"
        "void plastic white 0 0 5 1 1 1 0 0\n"
        "white polygon floor 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n";
    test::TracedScene scene(text, test::bounce_settings(4096));
    // Form factor of a 2 x 2 square from a point 2 below its centre, times half of 10
    const double side = 0.5, root = std::sqrt(1 + side * side);
    const double factor = 4 / (2 * 3.14159265358979) * 2 * (side / root) * std::atan(side / root);
    EXPECT_NEAR(scene.radiance({0, 0, 1}, {0, 0, -1})[0], 5 * factor, 0.05);
}

}  // namespace
}  // namespace infra
