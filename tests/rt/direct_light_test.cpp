// Light that comes straight from sources, against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "rt/sources/brightest_first.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
using test::words;

constexpr double pi = std::numbers::pi;
const std::string lamp = "void light lamp 0 0 3 1 1 1\n";
const test::RaySpec ground{{0, 0, 0}, {0, 0, 1}};

RenderSettings fine(double jitter = 0) {
    RenderSettings settings;
    settings.source_size_ratio = 0.01;
    settings.source_jitter = jitter;
    return settings;
}

/// View factor of a rectangle a x b from an element below one of its corners, at distance c.
double corner_factor(double a, double b, double c) {
    const double x = a / c, y = b / c, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * pi);
}

const std::string unit_square = "lamp polygon p 0 0 12 -.5 -.5 1 -.5 .5 1 .5 .5 1 .5 -.5 1\n";

TEST(DirectLight, UnitSquareOverheadInFineParts) {
    test::TracedScene scene(lamp + unit_square, fine());
    const double expected = 4 * pi * corner_factor(0.5, 0.5, 1);
    // -ds divides into 64 parts at most, each aimed at its middle
    EXPECT_NEAR(scene.irradiance(ground.origin, ground.direction), expected, 4e-3 * expected);
}

TEST(DirectLight, UnitSquareOverheadIsExactOnAverageWithFullJitter) {
    test::TracedScene scene(lamp + unit_square, fine(1));
    test::expect_close(scene.mean_irradiance(3000, [](RandomStream&) { return ground; }),
                       4 * pi * corner_factor(0.5, 0.5, 1), 1e-3);
    // below a corner, facing away from the square so that half of it is behind the horizon
    test::expect_close(scene.mean_irradiance(20'000,
                                             [](RandomStream&) {
                                                 return test::RaySpec{{0, 0, 0}, {1, 0, 0}};
                                             }),
                       // an element perpendicular to the rectangle: sum over both halves in y
                       2 * 0.5 * (std::atan(0.5) - 1 / std::sqrt(1.25) * std::atan(0.5 / std::sqrt(1.25))),
                       4e-3);
}

TEST(DirectLight, DistantSunGivesRadianceTimesSolidAngle) {
    for (const double elevation : {90.0, 40.0, 5.0}) {
        const Vec3 to_sun = test::direction((90 - elevation) * degree, 1.0);
        test::TracedScene scene(words("void light sun 0 0 3 1e4 1e4 1e4 sun source s 0 0 4", to_sun.x,
                                      to_sun.y, to_sun.z, ".533\n"));
        const double solid_angle = 2 * pi * (1 - std::cos(0.2665 * degree));
        const double expected = 1e4 * solid_angle * to_sun.z;
        EXPECT_NEAR(scene.irradiance(ground.origin, ground.direction), expected, 1e-5 * expected)
            << elevation;
    }
}

TEST(DirectLight, SphereGivesItsProjectedArea) {
    for (const double distance : {3.0, 30.0}) {
        test::TracedScene scene(words(lamp, "lamp sphere s 0 0 4 0 0", distance, ".1\n"));
        const double expected = pi * 0.01 / (distance * distance);
        EXPECT_NEAR(scene.irradiance(ground.origin, ground.direction), expected, 1e-5 * expected) << distance;
    }
}

// Unlike RADIANCE 6.1, whose map from square to disk crowds the rim and gives 0.6134 here.
TEST(DirectLight, DiskOverheadIsExactOnAverageWithFullJitter) {
    const std::string disk = "lamp ring r 0 0 8 0 0 1 0 0 -1 0 .5\n";
    test::TracedScene spread(lamp + disk, fine(1));
    test::expect_close(spread.mean_irradiance(4000, [](RandomStream&) { return ground; }), pi * 0.25 / 1.25,
                       1e-3);
}

// The middles of its parts lie where RADIANCE 6.1 has them: its figure for -ds .01 -dj 0.
TEST(DirectLight, DiskOverheadWithoutJitterIsAsInRadiance) {
    test::TracedScene still(lamp + "lamp ring r 0 0 8 0 0 1 0 0 -1 0 .5\n", fine());
    EXPECT_NEAR(still.irradiance(ground.origin, ground.direction), 0.614864, 2e-4);
}

// Nor are the axes of its parts just any across the normal: its figures for -ds .1 -dj 0 -u-.
TEST(DirectLight, SlantedDiskWithoutJitterIsAsInRadiance) {
    RenderSettings settings = fine();
    settings.source_size_ratio = 0.1;
    test::TracedScene still(lamp + "lamp ring r 0 0 8 0 0 2 1 2 -2 0 1\n", settings);
    EXPECT_NEAR(still.irradiance(ground.origin, ground.direction), 0.5203338, 2e-5);
    EXPECT_NEAR(still.irradiance({0.5, 0.9, 0}, ground.direction), 0.4257865, 2e-5);
    EXPECT_NEAR(still.irradiance({-0.7, 1, 0}, ground.direction), 0.3534932, 2e-5);
}

TEST(DirectLight, SourcesAreDarkFromBehindAndBelowTheHorizon) {
    test::TracedScene scene(lamp + unit_square);
    EXPECT_EQ(scene.irradiance({0, 0, 2}, {0, 0, -1}), 0);
    EXPECT_EQ(scene.irradiance({0, 0, 0}, {0, 0, -1}), 0);
}

TEST(DirectLight, SpotlightEndsAtHalfItsAngle) {
    test::TracedScene scene(
        "void spotlight spot 0 0 7 1000 1000 1000 40 0 0 -1\nspot sphere s 0 0 4 0 0 1 .01\n");
    const auto at = [&](double off_axis_deg) {
        return scene.irradiance({std::tan(off_axis_deg * degree), 0, 0}, {0, 0, 1});
    };
    EXPECT_GT(at(0), 0);
    EXPECT_GT(at(19.5), 0);
    EXPECT_EQ(at(20.5), 0);
    EXPECT_EQ(at(60), 0);
    // The beam spreads from one unit behind the source.
    EXPECT_NEAR(at(0), 1000 * pi * 1e-4 / 4, 1e-3 * 1000 * pi * 1e-4 / 4);
}

TEST(DirectLight, GlowEndsAtItsReach) {
    test::TracedScene scene("void glow g 0 0 4 1 1 1 2\ng sphere s 0 0 4 0 0 5 .1\n");
    EXPECT_GT(scene.irradiance({0, 0, 3.1}, {0, 0, 1}), 0);
    EXPECT_EQ(scene.irradiance({0, 0, 2}, {0, 0, 1}), 0);
}

TEST(DirectLight, ShadowsAreComplete) {
    test::TracedScene scene(lamp + unit_square +
                            "void plastic p 0 0 5 .5 .5 .5 0 0\np ring screen 0 0 8 0 0 .5 0 0 1 0 2\n");
    EXPECT_EQ(scene.irradiance(ground.origin, ground.direction), 0);
}

TEST(DirectLight, ManySourcesAddUp) {
    RenderSettings exact;
    exact.shadow_threshold = 0;
    std::string text = lamp;
    double expected = 0;
    for (int n = 0; n < 40; ++n) {
        const Vec3 place = test::direction(80 * degree * n / 40, n) * (5.0 + n);
        text += words("lamp sphere s 0 0 4", place.x, place.y, place.z, ".1\n");
        expected += pi * 0.01 / dot(place, place) * place.z / length(place);
    }
    test::TracedScene all(text, exact);
    EXPECT_NEAR(all.irradiance(ground.origin, ground.direction), expected, 2e-3 * expected);
    test::TracedScene some(text);  // by -dt and -dc a part of the sources is not tested for shadow
    EXPECT_NEAR(some.irradiance(ground.origin, ground.direction), expected, 2e-3 * expected);
}

// Lamps that are as bright everywhere are not asked by a ray of their own: those with a pattern are. What
// they shine on sees no difference, from either side of them.
TEST(DirectLight, EvenSourcesGiveWhatPatternedOnesGive) {
    const std::string shapes =
        "lamp polygon p 0 0 12 -.5 -.5 1 -.5 .5 1 .5 .5 1 .5 -.5 1\nlamp sphere s 0 0 4 2 0 1 .3\n"
        "lamp cylinder c 0 0 7 0 2 1 0 3 1 .1\n"
        "lamp ring r 0 0 8 0 -2 1 0 0 -1 0 .2\nlamp source sun 0 0 4 .3 .2 1 2\n";
    test::TracedScene even(lamp + shapes, fine(0.9));
    test::TracedScene asked("void brightfunc one 2 1 . 0 0\none light lamp 0 0 3 1 1 1\n" + shapes,
                            fine(0.9));
    RandomStream random(31, 0);
    for (int i = 0; i < 200; ++i) {
        const Vec3 place(4 * random.uniform() - 2, 4 * random.uniform() - 2, 2 * random.uniform());
        const Vec3 normal = test::direction(pi * random.uniform(), 2 * pi * random.uniform());
        EXPECT_EQ(even.irradiance(place, normal), asked.irradiance(place, normal));
    }
}

TEST(DirectLight, BrightestFirstKeepsTheOrderOfEqualOnes) {
    RandomStream random(17, 0);
    std::vector<Ranked> spare;
    for (const std::size_t count : {0, 1, 100, 256, 257, 5000}) {
        std::vector<float> values;
        std::vector<Ranked> list;
        for (std::size_t i = 0; i < count; ++i) {
            values.push_back(i % 7 == 0 ? 0.25f : static_cast<float>(std::exp(60 * random.uniform() - 40)));
            list.emplace_back(values.back(), static_cast<std::uint32_t>(i));
        }
        sort_brightest_first(list, spare);
        ASSERT_EQ(list.size(), count);
        for (std::size_t i = 1; i < count; ++i) {
            const std::uint32_t a = list[i - 1].place(), b = list[i].place();
            EXPECT_TRUE(values[a] > values[b] || (values[a] == values[b] && a < b)) << i;
        }
    }
}

}  // namespace
}  // namespace infra
