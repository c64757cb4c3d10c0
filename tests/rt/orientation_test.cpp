// plastic2, metal2, trans2 and ashik2: which way they are rough, and what happens where nothing says it.
#include <gtest/gtest.h>

#include "rt/materials/scattering.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;

// Reflected light of a small lamp at an angle from the mirror direction, along `azimuth`.
double glint(const std::string& material, double azimuth) {
    const double tilt = 16 * degree;
    const Vec3 lamp = test::direction(tilt, azimuth) * 50.0;
    test::TracedScene scene(material + test::plate +
                            test::words("void light bulb 0 0 3 1000 1000 1000 bulb sphere lamp 0 0 4", lamp.x,
                                        lamp.y, lamp.z, ".05\n"));
    return static_cast<double>(scene.radiance({0, 0, 3}, {0, 0, -1})[0]);
}

TEST(Orientation, IsTheDirectionOfTheFirstRoughness) {
    for (const std::string vector : {"1 0 0 .", "5 0 3 .", "0 1 0 . -rz -90", "0 0 1 . -ry 90 -s 3"}) {
        const std::string count = vector.size() < 9 ? "4 " : vector.size() < 16 ? "6 " : "8 ";
        const std::string metal = "void metal2 m " + count + vector + " 0 6 1 1 1 1 .3 .05";
        EXPECT_GT(glint(metal, 0), 3 * glint(metal, 90 * degree)) << metal;
        const std::string ashik = "void ashik2 m " + count + vector + " 0 8 0 0 0 1 1 1 10 2000";
        EXPECT_GT(glint(ashik, 0), 3 * glint(ashik, 90 * degree)) << ashik;
    }
}

TEST(Orientation, OfEqualRoughnessIsTheIsotropicMaterial) {
    const double plain = glint("void metal m 0 0 5 .9 .9 .9 .8 .15", 1);
    EXPECT_NEAR(glint("void metal2 m 4 1 2 0 . 0 6 .9 .9 .9 .8 .15 .15", 1) / plain, 1, 1e-5);
}

// Along the normal, zero, or without value: as RADIANCE, the same all around.
TEST(Orientation, ThatIsNoneGivesTheMeanRoughness) {
    const double mean = std::sqrt((0.3 * 0.3 + 0.1 * 0.1) / 2);
    const double plain = glint(test::words("void plastic m 0 0 5 .9 .9 .9 .2", mean), 1);
    for (const std::string vector : {"0 0 1 .", "0 0 0 .", "sqrt(-1-Px*Px) 1 0 ."})
        EXPECT_NEAR(glint("void plastic2 m 4 " + vector + " 0 6 .9 .9 .9 .2 .3 .1", 1) / plain, 1, 1e-5)
            << vector;
    const double even = glint("void ashik2 m 4 1 0 0 . 0 8 .2 .2 .2 .5 .5 .5 15 15", 1);
    EXPECT_NEAR(glint("void ashik2 m 4 0 0 1 . 0 8 .2 .2 .2 .5 .5 .5 10 30", 1) / even, 1, 1e-4);
}

TEST(Trans2, LetsNoLightSourceShineThroughUnseen) {
    test::TracedScene scene("void trans2 m 4 1 0 0 . 0 8 1 1 1 0 .1 .2 1 1" + test::plate +
                            "void light bulb 0 0 3 1000 1000 1000 bulb sphere lamp 0 0 4 0 0 50 .5\n"
                            "void plastic white 0 0 5 1 1 1 0 0 white ring below 0 0 8 0 0 -1 0 0 1 0 .5\n");
    EXPECT_EQ(scene.radiance({0.3, 0, -0.5}, {0, 0, -1})[0], 0.0f);  // in its shadow
    EXPECT_GT(scene.radiance({0, 0, -0.5}, {0, 0, 1})[0], 0.0f);     // but the sheet itself glows
}

}  // namespace
}  // namespace infra
