// Closed forms of radiant exchange between diffuse surfaces: VALIDATION V4, V6 and V15.
#include <gtest/gtest.h>

#include <numbers>

#include "common/planck/planck.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

constexpr double pi = std::numbers::pi;
constexpr double bar = 1e-3;

double long_wave(double temperature) { return band_radiance(temperature, 8, 12); }

/// A diffuse grey surface of this emissivity and temperature as modifier `name`.
std::string grey(const std::string& name, double emissivity, double black_body) {
    const double r = 1 - emissivity, le = emissivity * black_body;
    return words("void plastic", name + "_skin", "0 0 5", r, r, r, "0 0\nvoid emissive", name, "1",
                 name + "_skin", "0 3", le, le, le, "\n");
}

Vec3 on_sphere(RandomStream& random) {
    const double z = 2 * random.uniform() - 1;
    return test::direction(std::acos(z), 2 * pi * random.uniform());
}
/// Directions around z with density cos / pi.
Vec3 lambertian(RandomStream& random) {
    const double u = random.uniform(), r = std::sqrt(u), phi = 2 * pi * random.uniform();
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)};
}

TEST(Exchange, ConcentricSpheres) {
    test::TracedScene scene(grey("inner", 0.8, long_wave(300)) + grey("outer", 0.5, long_wave(280)) +
                                "inner sphere i 0 0 4 0 0 0 1\nouter bubble o 0 0 4 0 0 0 2\n",
                            test::path_settings());
    test::expect_close(scene.mean_radiance(150'000,
                                           [](RandomStream& random) {
                                               const Vec3 from = on_sphere(random);
                                               return test::RaySpec{from * 1.5, -from};
                                           }),
                       36.608773, bar);
    test::expect_close(scene.mean_radiance(150'000,
                                           [](RandomStream& random) {
                                               const Vec3 from = on_sphere(random);
                                               return test::RaySpec{from * 1.5, from};
                                           }),
                       29.042168, bar);
}

TEST(Exchange, InfiniteParallelPlates) {
    const double b1 = long_wave(300), b2 = long_wave(280), e1 = 0.3, e2 = 0.6;
    const double between = 1 - (1 - e1) * (1 - e2);
    test::TracedScene scene(grey("low", e1, b1) + grey("high", e2, b2) +
                                "low ring l 0 0 8 0 0 0 0 0 1 0 1e6\nhigh ring h 0 0 8 0 0 1 0 0 -1 0 1e6\n",
                            test::path_settings());
    test::expect_close(scene.mean_radiance(2000, {0, 0, 0.5}, {0.6, 0, -0.8}),
                       (e1 * b1 + (1 - e1) * e2 * b2) / between, bar);
    test::expect_close(scene.mean_radiance(2000, {0, 0, 0.5}, {0, 0.6, 0.8}),
                       (e2 * b2 + (1 - e2) * e1 * b1) / between, bar);
}

// The aperture is the part of a sphere above a height, where a mixture has no wall.
TEST(Exchange, SphericalCavityLooksBlackerThanItsWall) {
    struct Case {
        double emissivity, open_share, apparent;
    };
    for (const Case& c : {Case{0.5, 0.5, 0.666667}, {0.5, 0.1, 0.909091}, {0.7, 0.25, 0.903226}}) {
        SCOPED_TRACE(words("emissivity", c.emissivity, "open", c.open_share));
        const double rim = 1 - 2 * c.open_share;  // of the unit sphere
        test::TracedScene scene(
            grey("wall", c.emissivity, 1) + words("void mixfunc m 4 wall void if(A1-Pz,1,0) . 0 1", rim,
                                                  "\nm bubble cavity 0 0 4 0 0 0 1\n"),
            test::path_settings());
        const double radius = std::sqrt(1 - rim * rim);
        test::expect_close(scene.mean_radiance(300'000,
                                               [&](RandomStream& random) {
                                                   const double r = radius * std::sqrt(random.uniform());
                                                   const double phi = 2 * pi * random.uniform();
                                                   return test::RaySpec{
                                                       {r * std::cos(phi), r * std::sin(phi), rim - 1e-4},
                                                       -lambertian(random)};
                                               }),
                           c.apparent, bar);
    }
}

// CIE 171:2006, 5.8: mean indirect illuminance of a closed diffuse room.
TEST(Exchange, ClosedRoomFillsWithLight) {
    constexpr double flux = 10'000, side = 4, area = 6 * side * side, lamp = 0.01;
    struct Case {
        double reflectance, indirect;
        int rays;
    };
    for (const Case& c : {Case{0.3, 44.643, 250'000}, {0.7, 243.056, 150'000}, {0.9, 937.5, 100'000}}) {
        SCOPED_TRACE(c.reflectance);
        const double radiance = flux / (4 * pi * pi * lamp * lamp);
        const std::string room =
            words("void plastic m 0 0 5", c.reflectance, c.reflectance, c.reflectance, "0 0\n") +
            "m polygon x0 0 0 12 -2 -2 -2 -2 2 -2 -2 2 2 -2 -2 2\nm polygon x1 0 0 12 2 -2 -2 2 -2 2 2 2 2 2 "
            "2 -2\n"
            "m polygon y0 0 0 12 -2 -2 -2 -2 -2 2 2 -2 2 2 -2 -2\nm polygon y1 0 0 12 -2 2 -2 2 2 -2 2 2 2 "
            "-2 2 2\n"
            "m polygon z0 0 0 12 -2 -2 -2 2 -2 -2 2 2 -2 -2 2 -2\nm polygon z1 0 0 12 -2 -2 2 -2 2 2 2 2 2 2 "
            "-2 2\n" +
            words("void light lamp 0 0 3", radiance, radiance, radiance, "lamp sphere l 0 0 4 0 0 0", lamp,
                  "\n");
        test::TracedScene all(room, test::path_settings());
        RenderSettings direct_only = test::path_settings();
        direct_only.ambient_bounces = 0;
        test::TracedScene direct(room, direct_only);
        RandomStream random(4, 4);
        test::Mean indirect;
        for (int n = 0; n < c.rays; ++n) {
            const auto place = [&] { return 2 * (2 * random.uniform() - 1); };
            Vec3 point{place(), place(), place()}, normal{0};
            const int axis = n % 3;
            const double sign = n % 2 ? 1 : -1;
            point[axis] = 2 * sign;
            normal[axis] = -sign;
            indirect.add(all.irradiance(point, normal) - direct.irradiance(point, normal));
        }
        test::expect_close(indirect.estimate(), c.indirect, 5e-3);
        EXPECT_NEAR(c.indirect, flux / area * c.reflectance / (1 - c.reflectance), 1e-3);
    }
}

}  // namespace
}  // namespace infra
