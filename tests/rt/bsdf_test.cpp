// BSDF and aBSDF in a scene. What their tables answer is tested in tests/bsdf.
#include <gtest/gtest.h>

#include <numbers>

#include "bsdf/bsdf_text.h"
#include "common/error.h"
#include "common/test_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using std::numbers::pi;
using test::disk_lobe;

RenderSettings settings() {
    RenderSettings result = test::bounce_settings(64);
    result.min_weight = 1e-6;
    return result;
}

// A constant file is a Lambertian surface, to which the primitive's numbers add.
TEST(BsdfMaterial, OfAConstantReflectsAndTransmitsLambertian) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "flat.xml", test::matrix_file(disk_lobe(0.1, 0, 1), disk_lobe(0.05, 0, 1)));
    const std::string file = folder / "flat.xml";
    test::TracedScene plain("void BSDF m 6 0 " + file + " 0 1 0 . 0 0" + test::plate + test::surrounding(1),
                            settings());
    test::TracedScene added(
        "void BSDF m 6 0 " + file + " 0 1 0 . 0 9 .1 0 0 .2 0 0 .05 0 0" + test::plate + test::surrounding(1),
        settings());
    EXPECT_NEAR(plain.radiance({0, 0, 3}, {0, 0, -1})[0], 0.15 * pi, 1e-4);
    EXPECT_NEAR(plain.radiance({0, 0, -3}, {0, 0, 1})[0], 0.05 * pi, 1e-4);
    EXPECT_NEAR(added.radiance({0, 0, 3}, {0, 0, -1})[0], 0.15 * pi + 0.15, 1e-4);
    EXPECT_NEAR(added.radiance({0, 0, -3}, {0, 0, 1})[0], 0.05 * pi + 0.25, 1e-4);
}

TEST(BsdfMaterial, OfThicknessIsNotSeenAndCastsNoShadow) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "flat.xml", test::matrix_file(disk_lobe(0.1, 0, 1), disk_lobe(0.05, 0, 1)));
    const std::string behind =
        " void light l 0 0 3 100 100 100 l source sun 0 0 4 0 0 1 1 void plastic p 0 0 5 .5 .5 .5 0 0"
        " p polygon floor 0 0 12 -3 -3 -1 3 -3 -1 3 3 -1 -3 3 -1\n";
    test::TracedScene without(behind, settings());
    const float seen = without.radiance({0.1, 0, 3}, {0, 0, -1})[0];
    EXPECT_GT(seen, 0);
    RenderSettings direct = settings();
    direct.ambient_bounces = 0;
    for (const char* thickness : {".5", "-.5"}) {
        test::TracedScene scene("void BSDF m 6 " + std::string(thickness) + " " + (folder / "flat.xml") +
                                    " 0 1 0 . 0 0" + test::plate + behind,
                                direct);
        EXPECT_EQ(scene.radiance({0.1, 0, 3}, {0, 0, -1})[0], seen);
        EXPECT_EQ(scene.radiance({0.1, 0, -.5}, {0, 0, -1})[0], seen);
    }
}

TEST(BsdfMaterial, OfThicknessIsLookedThroughForIrradiance) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "flat.xml", test::matrix_file(disk_lobe(0.1, 0, 1), disk_lobe(0.05, 0, 1)));
    RenderSettings irradiance = settings();
    irradiance.irradiance = true;
    irradiance.ambient_bounces = 0;
    const auto seen = [&](const std::string& thickness) {
        test::TracedScene scene("void BSDF m 6 " + thickness + " " + (folder / "flat.xml") + " 0 1 0 . 0 0" +
                                    test::plate +
                                    " void light l 0 0 3 100 100 100 l source sun 0 0 4 0 0 -1 1\n",
                                irradiance);
        return scene.radiance({0.1, 0, 3}, {0, 0, -1})[0];
    };
    EXPECT_EQ(seen("0"), 0) << "lit from behind";
    EXPECT_EQ(seen(".5"), 100) << "the lamp itself";
}

TEST(BsdfMaterial, OfZeroThicknessBlocksLight) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "flat.xml", test::matrix_file(disk_lobe(0.1, 0, 1), disk_lobe(0.05, 0, 1)));
    for (const char* thickness : {"0", "1-1"}) {
        RenderSettings direct = settings();
        direct.ambient_bounces = 0;
        test::TracedScene scene(
            "void BSDF m 6 " + std::string(thickness) + " " + (folder / "flat.xml") + " 0 1 0 . 0 0" +
                test::plate +
                " void light l 0 0 3 100 100 100 l source sun 0 0 4 0 0 1 1"
                " void plastic p 0 0 5 .5 .5 .5 0 0 p polygon floor 0 0 12 -3 -3 -1 3 -3 -1 "
                "3 3 -1 -3 3 -1\n",
            direct);
        EXPECT_EQ(scene.radiance({0.1, 0, -.5}, {0, 0, -1})[0], 0);
    }
}

// The up vector turns the file's axes: a lobe to the file's right is found where right is.
TEST(BsdfMaterial, IsLaidByItsUpVector) {
    const test::TemporaryFolder folder;
    const auto to_the_right = [](const Point2&, const Point2& out) {
        return 0.01 + (out[0] > 0.4 && std::abs(out[1]) < 0.4 ? 1.0 : 0.0);
    };
    test::write_file(folder / "right.xml", test::tree_file(4, to_the_right, disk_lobe(0, 0, 1)));
    const auto seen = [&](const char* up, const std::string& sun) {
        RenderSettings direct = settings();
        direct.ambient_bounces = 0;
        test::TracedScene scene("void BSDF m 6 0 " + (folder / "right.xml") + " " + up + " . 0 0" +
                                    test::plate + " void light l 0 0 3 100 100 100 l source sun 0 0 4 " +
                                    sun + " 1\n",
                                direct);
        return scene.radiance({0, 0, 3}, {0, 0, -1})[0];
    };
    EXPECT_GT(seen("0 1 0", "1 0 1"), 10 * seen("0 1 0", "0 1 1"));
    EXPECT_GT(seen("1 0 0", "0 -1 1"), 10 * seen("1 0 0", "1 0 1"));
    EXPECT_EQ(seen("0 0 1", "1 0 1"), 0) << "no direction in the surface";
}

TEST(ApertureBsdf, LetsViewAndShadowRaysThroughUnscattered) {
    const test::TemporaryFolder folder;
    const AngleBasis& basis = *standard_angle_basis("LBNL/Klems Quarter");
    // Half of the light goes straight on: from each patch into the same one.
    const auto holes = [&](const Point2& in, const Point2& out) {
        const int patch = basis.patch_of({in[0], in[1], std::sqrt(1 - in[0] * in[0] - in[1] * in[1])});
        const int other = basis.patch_of({out[0], out[1], std::sqrt(1 - out[0] * out[0] - out[1] * out[1])});
        return 0.01 + (patch == other ? 0.5 / basis.projected_solid_angle(patch) : 0.0);
    };
    test::write_file(folder / "holes.xml", test::matrix_file(disk_lobe(0, 0, 1), holes));
    RenderSettings direct = settings();
    direct.ambient_bounces = 0;
    const std::string behind =
        " void light l 0 0 3 100 100 100 l source sun 0 0 4 0 0 1 1 void plastic p 0 0 5 .5 .5 .5 0 0"
        " p polygon floor 0 0 12 -3 -3 -1 3 -3 -1 3 3 -1 -3 3 -1\n";
    test::TracedScene without(behind, direct);
    test::TracedScene scene(
        "void aBSDF m 5 " + (folder / "holes.xml") + " 0 1 0 . 0 0" + test::plate + behind, direct);
    const double open = without.radiance({0.1, 0, -.5}, {0, 0, -1})[0];
    EXPECT_NEAR(scene.radiance({0.1, 0, -.5}, {0, 0, -1})[0], 0.5 * open, 1e-3 * open);
}

// A peak of many patches with nothing around it is no aperture: all of nothing counts as one patch, which is
// less than a fifth of the peak, as in RADIANCE 6.1.
TEST(ApertureBsdf, OfAWidePeakOverNothingIsNone) {
    const test::TemporaryFolder folder;
    const auto through_peak = [&](double radius2) {
        const auto peak = [=](const Point2& in, const Point2& out) {
            const double dx = in[0] - out[0], dy = in[1] - out[1];
            return 0.01 + (dx * dx + dy * dy < radius2 ? 1.0 : 0.0);
        };
        test::write_file(folder / "peak.xml", test::tree_file(3, disk_lobe(0, 0, 1), peak));
        RenderSettings direct = settings();
        direct.ambient_bounces = 0;
        direct.specular_threshold = 1;
        test::TracedScene scene(
            "void aBSDF m 5 " + (folder / "peak.xml") + " 0 1 0 . 0 0" + test::plate + test::surrounding(1),
            direct);
        return scene.radiance({0.1, 0, 3}, {0, 0, -1})[0];
    };
    EXPECT_GT(through_peak(0.03), 0.09);
    EXPECT_EQ(through_peak(0.1), 0);
}

TEST(BsdfMaterial, NamesWhatItMisses) {
    try {
        test::TracedScene scene("void BSDF m 6 0 nowhere.xml 0 1 0 . 0 0" + test::plate);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("test.rad:1: "), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("cannot find BSDF file \"nowhere.xml\""), std::string::npos);
    }
}

}  // namespace
}  // namespace infra
