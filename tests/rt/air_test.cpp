// Air along camera rays: what it applies to, and what not.
#include <gtest/gtest.h>

#include "common/test_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

// Half of the radiance gets through each unit of length, and the air itself is worth 8.
class Air : public ::testing::Test {
  protected:
    Air() { test::write_file(folder_ / "air.txt", "1 .5 4\n"); }

    double seen(const std::string& text, const Vec3& origin, const Vec3& direction) {
        RenderSettings settings = test::bounce_settings(16);
        settings.air_path = folder_ / "air.txt";
        test::TracedScene scene(text, settings);
        return double(scene.radiance(origin, direction)[0]);
    }

    test::TemporaryFolder folder_;
    static constexpr double bar = 1e-5;
};

double through(double units, double radiance) {
    const double tau = std::pow(0.5, units);
    return tau * radiance + (1 - tau) * 8;
}

TEST_F(Air, LiesBetweenTheCameraAndASurface) {
    EXPECT_NEAR(seen("void glow m 0 0 4 20 20 20 0" + test::plate, {0.1, 0.2, 3}, {0, 0, -1}), through(3, 20),
                bar);
    EXPECT_NEAR(seen("void emissive m 0 0 3 0 0 0" + test::plate, {0.1, 0.2, 2}, {0, 0, -1}), through(2, 0),
                bar);
}

TEST_F(Air, LeavesTheSkyAsItIs) {
    EXPECT_NEAR(
        seen("void plastic m 0 0 5 0 0 0 0 0" + test::plate + test::surrounding(10), {0, 0, 3}, {0, 0, 1}),
        10, bar);
}

TEST_F(Air, DoesNotTouchReflectedRays) {
    const std::string lamp = "void glow lamp 0 0 4 20 20 20 0 lamp ring l 0 0 8 0 0 5 0 0 -1 0 50\n";
    EXPECT_NEAR(seen(lamp + "void metal m 0 0 5 .5 .5 .5 1 0" + test::plate, {0, 0, 1}, {0, 0, -1}),
                through(1, 10), 1e-3);
    EXPECT_NEAR(seen("void plastic m 0 0 5 .5 .5 .5 0 0" + test::plate + test::surrounding(10), {0, 0, 1},
                     {0, 0, -1}),
                through(1, 5), 1e-3);
}

// The way goes on behind a pane: as much air as without it.
TEST_F(Air, GoesOnBehindGlass) {
    const std::string pane = "void glass clear 0 0 4 1 1 1 1 clear ring pane 0 0 8 0 0 1 0 0 1 0 5\n";
    const std::string glow = "void glow m 0 0 4 20 20 20 0" + test::plate;
    EXPECT_NEAR(seen(pane + glow, {0.1, 0.2, 3}, {0, 0, -1}), through(3, 20), bar);
    const std::string window = "void mixfunc half 4 void clear .5 . 0 0\n";
    EXPECT_NEAR(seen(pane + window + "half ring w 0 0 8 0 0 2 0 0 1 0 5\n" + glow, {0.1, 0.2, 3}, {0, 0, -1}),
                through(3, 20), bar);
}

// The sky is as the camera sees it behind anything clear, too.
TEST_F(Air, LeavesTheSkyBehindClearThings) {
    const std::string sky = test::surrounding(10);
    const Vec3 origin{0.1, 0.2, 1}, up{0, 0, 1};
    const std::string sheet = "\nm ring sheet 0 0 8 0 0 4 0 0 1 0 5\n";
    EXPECT_NEAR(seen("void trans m 0 0 7 1 1 1 0 0 1 1" + sheet + sky, origin, up), 10, bar);
    EXPECT_NEAR(
        seen("void glass pane 0 0 4 1 1 1 1 void mixfunc m 4 void pane .3 . 0 0" + sheet + sky, origin, up),
        10, bar);
    // Half a black sheet, half sky
    EXPECT_NEAR(seen("void plastic dark 0 0 5 0 0 0 0 0 void mixfunc m 4 void dark .5 . 0 0" + sheet + sky,
                     origin, up),
                0.5 * 10 + 0.5 * through(3, 0), bar);
    EXPECT_NEAR(seen("void trans m 0 0 7 .5 .5 .5 0 0 1 1" + sheet + sky, origin, up),
                0.5 * 10 + 0.5 * through(3, 0), bar);
}

TEST_F(Air, HasNoPartInIrradiance) {
    RenderSettings settings = test::bounce_settings(64);
    settings.irradiance = true;
    const std::string text = "void plastic m 0 0 5 .5 .5 .5 0 0" + test::plate + test::surrounding(10);
    test::TracedScene vacuum(text, settings);
    settings.air_path = folder_ / "air.txt";
    test::TracedScene air(text, settings);
    const Vec3 origin{0.1, 0.2, 1}, down{0, 0, -1};
    EXPECT_EQ(air.radiance(origin, down)[0], vacuum.radiance(origin, down)[0]);
}

// Where a view is clipped in front (-vo) the way from the camera counts.
TEST_F(Air, BeginsAtTheCamera) {
    RenderSettings settings;
    settings.air_path = folder_ / "air.txt";
    test::TracedScene scene("void glow m 0 0 4 20 20 20 0" + test::plate, settings);
    Ray ray = scene.tracer().primary({0.1, 0.2, 1}, {0, 0, -1}, 0);
    ray.fore = 2;
    Interaction at(ray);
    scene.tracer().trace(at);
    EXPECT_NEAR(double(at.radiance[0]), through(3, 20), bar);
}

}  // namespace
}  // namespace infra
