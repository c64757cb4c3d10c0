// Bodies of clear matter: where light goes at their surfaces, how much of it, and what they absorb.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "traced_scene.h"

namespace infra {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// No sampling but of mirror and through rays, followed as long as they weigh anything.
RenderSettings specular_settings() {
    RenderSettings settings;
    settings.max_reflections = 60;
    settings.min_weight = 1e-9;
    return settings;
}

/// Fresnel's reflectance for unpolarised light that comes at angle a and goes on at angle b.
double fresnel(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const auto squared = [](double x) { return x * x; };
    return 0.5 * (squared(std::sin(a - b) / std::sin(a + b)) + squared(std::tan(a - b) / std::tan(a + b)));
}

/// What a ray brings back that ends nowhere but in a uniform sky of radiance 1, seen through the first
/// surface.
double seen(const std::string& scene, const Vec3& origin, const Vec3& direction) {
    test::TracedScene traced(scene + test::surrounding(1), specular_settings());
    return static_cast<double>(traced.radiance(origin, normalize(direction))[0]);
}

const std::string plate = " polygon plate 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n";
const std::string slab = "g ring top 0 0 8 0 0 1 0 0 1 0 99 g ring bottom 0 0 8 0 0 0 0 0 -1 0 99\n";

/// The plane x = 50 shows where a ray arrives: as much radiance as its height and 300.
const std::string scale =
    "void brightfunc height 2 Pz+300 . 0 0 height glow mark 0 0 4 1 1 1 0 mark polygon scale 0 0 12 "
    "50 -99 300 50 99 300 50 99 -300 50 -99 -300\n";

TEST(Dielectric, BendsRaysBySnell) {
    for (const double angle : {20.0, 45.0, 70.0, 89.0}) {
        const double a = angle * degree, b = std::asin(std::sin(a) / 1.5);
        test::TracedScene scene("void dielectric m 0 0 5 1 1 1 1.5 0 m" + plate + scale, specular_settings());
        const Vec3 along{std::sin(a), 0, -std::cos(a)};
        const double bent = (1 - fresnel(a, b)) / 2.25 * (300 - 50 / std::tan(b));
        const double mirrored = fresnel(a, b) * (300 + 50 / std::tan(a));
        EXPECT_NEAR(scene.radiance(-along, along)[0], bent + mirrored, 1e-5 * (bent + mirrored)) << angle;
    }
}

TEST(Dielectric, ReflectsAllBeyondTheCriticalAngle) {
    const std::string scene = "void dielectric m 0 0 5 1 1 1 1.5 0 m" + plate;
    const double critical = std::asin(1 / 1.5);
    for (const double beyond : {0.01, 0.3}) {
        const double a = critical + beyond;
        EXPECT_NEAR(seen(scene, {0, 0, -1}, {std::sin(a), 0, std::cos(a)}), 1, 1e-5);
    }
    const double a = critical - 0.1, b = std::asin(1.5 * std::sin(a));
    const double reflected = fresnel(a, b);
    EXPECT_NEAR(seen(scene, {0, 0, -1}, {std::sin(a), 0, std::cos(a)}), reflected + 2.25 * (1 - reflected),
                1e-5);
}

// Radiance over the square of the index is what is kept: R + T = 1 from either side.
TEST(Dielectric, KeepsEnergyWithRadianceOverTheSquareOfTheIndex) {
    for (const double angle : {0.0, 30.0, 60.0, 85.0}) {
        const double a = angle * degree, b = std::asin(std::sin(a) / 1.5);
        const double r = angle == 0 ? 0.04 : fresnel(a, b);
        const Vec3 along{std::sin(a), 0, -std::cos(a)};
        EXPECT_NEAR(seen("void dielectric m 0 0 5 1 1 1 1.5 0 m" + plate, -along, along), r + (1 - r) / 2.25,
                    1e-5);
    }
}

TEST(Dielectric, OfAClearSlabLetsThroughTheSumOfAllReflectionsWithin) {
    for (const double angle : {0.0, 40.0, 75.0}) {
        const double a = angle * degree, b = std::asin(std::sin(a) / 1.5), t = std::pow(0.6, 1 / std::cos(b));
        const double r = angle == 0 ? 0.04 : fresnel(a, b);
        const double passes = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
        const double returns = r + r * t * passes;
        const Vec3 along{std::sin(a), 0, -std::cos(a)};
        EXPECT_NEAR(seen("void dielectric g 0 0 5 .6 .6 .6 1.5 0 " + slab, Vec3{0, 0, 2}, along),
                    passes + returns, 1e-5)
            << angle;
    }
}

TEST(Dielectric, AbsorbsByBeerAlongTheWayWithin) {
    const std::string ball = "void dielectric g 0 0 5 .9 .5 0 1.0000001 0 g sphere ball 0 0 4 0 0 0 2\n";
    test::TracedScene scene(ball + test::surrounding(1), specular_settings());
    for (const double offset : {0.0, 1.0, 1.9}) {
        const double way = 2 * std::sqrt(4 - offset * offset);
        const Spectrum through = scene.radiance({offset, -5, 0}, {0, 1, 0});
        EXPECT_NEAR(through[0], std::pow(0.9, way), 1e-5);
        EXPECT_NEAR(through[1], std::pow(0.5, way), 1e-5);
        EXPECT_NEAR(through[2], 0, 1e-5);
    }
    // From within only the rest of the way counts.
    EXPECT_NEAR(scene.radiance({0, 0, 0}, {0, 1, 0})[0], 0.81, 1e-5);
}

TEST(Dielectric, HasThePatternOfEachCrossingOnTheWayBeforeIt) {
    // Patterns multiply the transmissivity; on the way out that of the far side is used.
    const std::string scene =
        "void brightfunc by_side 2 if(Pz-.5,.3,.6) . 0 0 by_side dielectric g 0 0 5 1 1 1 1.0000001 0 " +
        slab;
    EXPECT_NEAR(seen(scene, {0, 0, 2}, {0, 0, -1}), 0.6, 1e-5);
    EXPECT_NEAR(seen(scene, {0, 0, -2}, {0, 0, 1}), 0.3, 1e-5);
}

TEST(Dielectric, HasTheIndexAtFiveHundredNanometres) {
    const std::string shape = " m" + plate;
    const auto at_right_angles = [&](const std::string& arguments) {
        return seen("void dielectric m 0 0 5 1 1 1 " + arguments + shape, {0, 0, 1}, {0, 0, -1});
    };
    EXPECT_EQ(at_right_angles("1.4 50"), at_right_angles("1.5 0"));
}

TEST(Dielectric, LetsShadowRaysThroughBothFaces) {
    const std::string lamp = "void light lum 0 0 3 100 100 100 lum sphere lamp 0 0 4 0 0 9 .1\n";
    const std::string floor = "void plastic white 0 0 5 1 1 1 0 0 white ring floor 0 0 8 0 0 -1 0 0 1 0 5\n";
    test::TracedScene open(lamp + floor),
        covered(lamp + floor + "void dielectric g 0 0 5 .5 .5 .5 1.5 0 " + slab);
    // The shadow ray leaves the far side without looking at what is reflected within.
    const float light = open.radiance({0.1, 0, -0.5}, {-0.2, 0, -1})[0];
    EXPECT_NEAR(covered.radiance({0.1, 0, -0.5}, {-0.2, 0, -1})[0] / light, 0.5 * 0.96 * 0.96, 1e-3);
}

TEST(Interface, HasTheFirstBodyBehindAndTheSecondInFront) {
    const std::string boundary = "void interface m 0 0 8 .5 .5 .5 1.6 .8 .8 .8 1.3 m" + plate;
    // Both bodies reach to a sky two units away, on shells that only emit.
    const std::string sky = "void glow g 0 0 4 1 1 1 0 g bubble shell 0 0 4 0 0 0 2\n";
    test::TracedScene scene(boundary + sky, specular_settings());
    const double r = std::pow((1.6 - 1.3) / (1.6 + 1.3), 2), ratio = 1.3 / 1.6;
    EXPECT_NEAR(scene.radiance({0, 0, 1}, {0, 0, -1})[0], 0.8 * (r * 0.64 + (1 - r) * ratio * ratio * 0.25),
                1e-5);
    EXPECT_NEAR(scene.radiance({0, 0, -1}, {0, 0, 1})[0], 0.5 * (r * 0.25 + (1 - r) / (ratio * ratio) * 0.64),
                1e-5);
}

}  // namespace
}  // namespace infra
