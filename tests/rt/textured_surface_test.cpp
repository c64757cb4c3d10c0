// Textures on the materials that are ours: they bend a table's lobe once, never below the true surface, and
// leave emission and the reflecting material apart.
#include <gtest/gtest.h>

#include "rt/materials/emissive_material.h"
#include "test_tables.h"
#include "traced_scene.h"

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
