// Interpolated irradiance in scenes whose irradiance is known.
#include "rt/ambient/irradiance_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "scene/octree_build.h"
#include "traced_scene.h"

namespace infra {
namespace {

using test::words;
constexpr double pi = std::numbers::pi;

RenderSettings cached_settings(int bounces, int divisions) {
    RenderSettings settings;
    settings.ambient_bounces = bounces;
    settings.ambient_divisions = divisions;
    settings.ambient_super_samples = 0;
    settings.ambient_accuracy = 0.1;
    settings.ambient_resolution = 64;
    settings.max_reflections = 20;
    settings.min_weight = 1e-6;
    return settings;
}

Cube cube_around(const std::string& rad) {
    Scene scene;
    read_rad_text(scene, rad, "test.rad", no_warnings());
    return bounding_cube(scene, 0);
}

/// A scene with a cache.
struct Cached : test::TracedScene {
    IrradianceCache cache;

    Cached(const std::string& rad, const RenderSettings& settings)
        : TracedScene(rad, settings),
          cache(cube_around(rad), 3, settings.ambient_accuracy, settings.ambient_resolution) {
        tracer().use_irradiance_cache(&cache);
    }
};

// Le = 0.5, albedo 0.5: radiance after b bounces is 1 - 0.5^(b + 1). Later bounces may use values of earlier
// ones, which have seen more: what is found lies between that and the furnace's 1.
TEST(IrradianceCache, IsExactInASphereFurnace) {
    for (const int bounces : {1, 3}) {
        Cached scene(
            "void plastic m 0 0 5 .5 .5 .5 0 0\nvoid emissive wall 1 m 0 3 .5 .5 .5\n"
            "wall bubble enclosure 0 0 4 0 0 0 1\n",
            cached_settings(bounces, 64));
        RandomStream random(3, 0);
        const double least = 1 - std::pow(0.5, bounces + 1), most = bounces == 1 ? least : 1;
        for (int i = 0; i < 300; ++i) {
            const Vec3 way = test::direction(std::acos(2 * random.uniform() - 1), 2 * pi * random.uniform());
            const double radiance = static_cast<double>(scene.radiance(Vec3(0.3, 0, 0), way)[0]);
            EXPECT_GE(radiance, least - 1e-5);
            EXPECT_LE(radiance, most + 1e-5);
        }
        EXPECT_GT(scene.cache.size(), 20u);
    }
}

// Values are asked for along lobe rays of every weight, and made for light ones first: those are no good for
// heavier ones. Roulette takes a value as a whole, so that it is kept and the rays come to an end.
TEST(IrradianceCache, IsExactInAGlossyFurnaceWithRoulette) {
    RenderSettings settings = cached_settings(100, 64);
    settings.ambient_accuracy = 1;
    settings.specular_threshold = 0;
    settings.max_reflections = 0;
    settings.min_weight = 1e-7;
    Cached scene(
        "void plastic m 0 0 5 .6 .6 .6 .3 .1\nvoid emissive wall 1 m 0 3 .28 .28 .28\n"
        "wall bubble enclosure 0 0 4 0 0 0 1\n",
        settings);
    RandomStream random(7, 0);
    for (int i = 0; i < 100; ++i) {
        const Vec3 way = test::direction(std::acos(2 * random.uniform() - 1), 2 * pi * random.uniform());
        EXPECT_NEAR(static_cast<double>(scene.radiance(Vec3(0.3, 0, 0), way)[0]), 1, 1e-3);
    }
    EXPECT_LT(scene.cache.size(), 20000u);
}

// A plane under a half sky of radiance 1, beside a black wall of height 1 and great length at x = 0.
const std::string yard =
    "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\nvoid plastic black 0 0 5 0 0 0 0 0\n"
    "black polygon wall 0 0 12 0 -400 0 0 400 0 0 400 1 0 -400 1\n"
    "black polygon floor 0 0 12 0 -5 0 10 -5 0 10 5 0 0 5 0\n";
double yard_irradiance(double x) { return pi * (0.5 + 0.5 * x / std::hypot(x, 1.0)); }

TEST(IrradianceCache, StaysWithinTheAccuracyBesideAWall) {
    RenderSettings settings = cached_settings(1, 1024);
    settings.ambient_resolution = 10000;  // the scene is as large as the wall is long
    Cached scene(yard, settings);
    double squares = 0;
    constexpr int places = 2000;
    RandomStream random(5, 0);
    for (int i = 0; i < places; ++i) {
        const double x = 0.2 + 5 * random.uniform();
        const double error =
            scene.irradiance({x, 4 * random.uniform() - 2, 0}, {0, 0, 1}) / yard_irradiance(x) - 1;
        EXPECT_LT(std::fabs(error), settings.ambient_accuracy) << x;
        squares += error * error;
    }
    EXPECT_LT(std::sqrt(squares / places), 0.02);
    EXPECT_LT(scene.cache.size(), places / 4u);
}

// One value, asked for by neighbours: they see its gradients.
TEST(IrradianceCache, MovesAValueAlongItsGradient) {
    constexpr double x = 1, step = 0.02;
    RenderSettings settings = cached_settings(1, 4096);
    settings.ambient_resolution = 4000;
    Cached scene(yard, settings);
    const double here = scene.irradiance({x, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(here, yard_irradiance(x), 0.01 * here);
    const double slope = (scene.irradiance({x + step, 0, 0}, {0, 0, 1}) - here) / step;
    const double sideways = (scene.irradiance({x, step, 0}, {0, 0, 1}) - here) / step;
    ASSERT_EQ(scene.cache.size(), 1u);
    const double expected = 0.5 * pi * std::pow(1 + x * x, -1.5);
    EXPECT_NEAR(slope, expected, 0.15 * expected);
    EXPECT_NEAR(sideways, 0, 0.1 * expected);
}

// A normal turned away from the wall by t sees (cos t + cos(a - t)) / 2 of the sky, a being the angle between
// the wall's top, seen from the place, and the zenith's complement.
TEST(IrradianceCache, TurnsAValueWithTheNormal) {
    constexpr double turn = 0.05, a = pi / 4;  // at x = 1
    RenderSettings settings = cached_settings(1, 4096);
    settings.ambient_resolution = 4000;
    Cached scene(yard, settings);
    const Vec3 place(1, 0, 0.001);
    const double here = scene.irradiance(place, {0, 0, 1});
    const double turned = scene.irradiance(place, {std::sin(turn), 0, std::cos(turn)});
    ASSERT_EQ(scene.cache.size(), 1u);
    const double expected = pi * 0.5 * std::sin(a) * turn;
    EXPECT_NEAR(turned - here, expected, 0.15 * expected);
}

// Two rooms with a wall of no thickness between them, one lit: no light leaks.
TEST(IrradianceCache, DoesNotLeakThroughAWall) {
    Cached scene(
        "void glow g 0 0 4 1 1 1 0\nvoid plastic m 0 0 5 0 0 0 0 0\n"
        "m polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n"
        "m polygon wall 0 0 12 0 -2 0 0 2 0 0 2 3 0 -2 3\n"
        "m polygon far_wall 0 0 12 -2 -2 0 -2 2 0 -2 2 3 -2 -2 3\n"
        "m polygon s1 0 0 12 -2 -2 0 0 -2 0 0 -2 3 -2 -2 3\n"
        "m polygon s2 0 0 12 -2 2 0 0 2 0 0 2 3 -2 2 3\n"
        "m polygon roof 0 0 12 -2 -2 3 0 -2 3 0 2 3 -2 2 3\n"
        "g source sky 0 0 4 0 0 1 180\n",
        cached_settings(1, 400));
    double darkest = 1e9, brightest = 0;
    for (int i = 1; i < 40; ++i)
        for (const double side : {1.0, -1.0}) {
            const double e = scene.irradiance({side * 0.05 * i, 0.3, 0}, {0, 0, 1});
            if (side > 0)
                darkest = std::min(darkest, e);
            else
                brightest = std::max(brightest, e);
        }
    EXPECT_GT(darkest, 1);
    EXPECT_LT(brightest, 1e-6);
}

// -aw: the mean of the values takes the place of -av.
TEST(IrradianceCache, AveragesItsValuesWhereBouncesEnd) {
    RenderSettings settings = cached_settings(1, 64);
    settings.ambient_value_weight = 1;
    for (float& c : settings.ambient_value) c = 0.01f;
    Cached scene(
        "void glow g 0 0 4 1 1 1 0\ng source all 0 0 4 0 0 1 360\nvoid plastic m 0 0 5 1 1 1 0 0\n"
        "m polygon floor 0 0 12 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n",
        settings);
    EXPECT_NEAR(scene.irradiance({0, 0, 0}, {0, 0, 1}), pi, 1e-4);
    ASSERT_EQ(scene.cache.lit_values(), 1u);
    EXPECT_NEAR(scene.cache.mean_log(), 0, 1e-5);
}

IrradianceValue value_at(const Vec3& point, double radiance) {
    IrradianceValue value(3);
    value.point = point;
    value.normal = {0, 0, 1};
    value.axis = {1, 0, 0};
    value.radius[0] = value.radius[1] = 0.5;
    value.radiance.fill(static_cast<float>(radiance));
    return value;
}

struct NoWalls : WallTest {
    bool hides(const Vec3&) override { return false; }
};

TEST(IrradianceCache, ValuesOfLaterBouncesAndOtherNormalsAreNotUsed) {
    IrradianceCache cache({Vec3(0), 1}, 3, 0.1, 64);
    IrradianceValue value = value_at({0.5, 0.5, 0.5}, 1);
    value.level = 1;
    cache.add(value);
    NoWalls walls;
    const auto weight = [&](const Vec3& point, const Vec3& normal, int level, double w) {
        Spectrum sum(3);
        return cache.interpolate({point, normal, normal, level, w}, walls, sum);
    };
    const Vec3 up(0, 0, 1), here(0.5, 0.5, 0.5);
    EXPECT_GT(weight(here, up, 1, 0.5), 0);
    EXPECT_GT(weight(here, up, 2, 0.5), 0);
    EXPECT_EQ(weight(here, up, 0, 1), 0);
    EXPECT_EQ(weight(here, -up, 1, 0.5), 0);
    EXPECT_EQ(weight(here, {1, 0, 0}, 1, 0.5), 0);
    EXPECT_EQ(weight({0.5, 0.56, 0.5}, up, 1, 0.5), 0);
    EXPECT_EQ(weight({0.5, 0.5, 0.49}, up, 1, 0.5), 0);  // behind
}

TEST(IrradianceCache, ValuesForLighterRaysAreNotUsed) {
    IrradianceCache cache({Vec3(0), 1}, 3, 0.1, 64);
    IrradianceValue value = value_at({0.5, 0.5, 0.5}, 1);
    value.level = 1;
    value.weight = 0.01;
    cache.add(value);
    NoWalls walls;
    const auto weight = [&](int level, double w) {
        Spectrum sum(3);
        return cache.interpolate({value.point, value.normal, value.normal, level, w}, walls, sum);
    };
    for (const int level : {1, 2, 5}) {
        EXPECT_GT(weight(level, 0.01), 0);
        EXPECT_EQ(weight(level, 0.02), 0);
    }
}

TEST(IrradianceCache, TakesValuesFromManyThreads) {
    IrradianceCache cache({Vec3(0), 1}, 3, 0.1, 64);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&cache, t] {
            RandomStream random(11, t);
            NoWalls walls;
            for (int i = 0; i < 2000; ++i) {
                const Vec3 point{random.uniform(), random.uniform(), 0.5};
                cache.add(value_at(point, 2));
                Spectrum sum(3);
                const double weight = cache.interpolate({point, {0, 0, 1}, {0, 0, 1}, 0, 1.0}, walls, sum);
                if (!(weight > 0) || std::fabs(sum[0] / weight - 2) > 1e-5) std::abort();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(cache.size(), 8000u);
}

TEST(IrradianceCache, AValueTakesAHundredBytes) { EXPECT_LE(IrradianceCache::value_bytes(3), 100u); }

}  // namespace
}  // namespace infra
