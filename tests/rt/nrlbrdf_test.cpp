// The nrlbrdf material in scenes: nsamp and alpha change the noise only, and each light is counted once.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::degree;
using test::words;

constexpr double pi = std::numbers::pi;
const test::RaySpec view = test::view_of_plate(50 * degree, 0.4);

// A gradient with a spot of 8 degrees in it, near the mirror direction.
constexpr double spot_radiance = 60, spot_half_angle = 8 * degree;
const Vec3 spot_direction = test::direction(40 * degree, 0.4 + pi);
double sky_radiance(const Vec3& d) { return 1 + d.z; }

// Of two glows in one direction the first is seen.
std::string sky_with_spot() {
    return words("void glow spot_glow 0 0 4", spot_radiance, spot_radiance, spot_radiance, "0\n",
                 "spot_glow source spot 0 0 4", spot_direction.x, spot_direction.y, spot_direction.z,
                 2 * spot_half_angle / degree, "\n",
                 "void brightfunc gradient 2 1+Dz . 0 0\ngradient glow sky_glow 0 0 4 1 1 1 0\n",
                 "sky_glow source sky 0 0 4 0 0 1 180\n");
}
std::string plate_of(const test::TableFile& file, int nsamp, double alpha) {
    return words("void nrlbrdf m 1", file.path, "0 5 1 1 1", nsamp, alpha, test::plate);
}

// Midpoint rule over the cap of directions within `half_angle` of `axis`.
template <class Function>
double cap_integral(const Vec3& axis, double half_angle, int steps, const Function& f) {
    Vec3 u, v;
    make_frame(axis, u, v);
    const double height = 1 - std::cos(half_angle);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double c = 1 - height * (i + 0.5) / steps, s = std::sqrt(1 - c * c);
            const double phi = 2 * pi * (k + 0.5) / steps;
            sum += f(axis * c + u * (s * std::cos(phi)) + v * (s * std::sin(phi)));
        }
    return sum * 2 * pi * height / (static_cast<double>(steps) * steps);
}

// What the viewer sees of the plate under the sky with its spot, by quadrature of the table alone.
double expected_radiance(const BrdfTable& table) {
    const Vec3 wo = -view.direction;
    const auto reflected = [&](const Vec3& wi, double radiance) {
        return wi.z > 0 ? table.eval(wo, wi) * wi.z * radiance : 0.0;
    };
    return cap_integral({0, 0, 1}, 90 * degree, 1500,
                        [&](const Vec3& wi) { return reflected(wi, sky_radiance(wi)); }) +
           cap_integral(spot_direction, spot_half_angle, 400,
                        [&](const Vec3& wi) { return reflected(wi, spot_radiance - sky_radiance(wi)); });
}

TEST(NrlBrdf, MeanDependsNeitherOnSampleCountNorOnAlpha) {
    const test::TemporaryFolder folder;
    for (const auto& file : test::write_tables(folder)) {
        const double expected = expected_radiance(*file.table);
        std::vector<test::Estimate> all;
        for (const int nsamp : {1, 4, 64})
            for (const double alpha : {0.05, 0.3, 1.0}) {
                SCOPED_TRACE(words(file.name, "nsamp", nsamp, "alpha", alpha));
                test::TracedScene scene(plate_of(file, nsamp, alpha) + sky_with_spot(),
                                        test::bounce_settings(16));
                const test::Estimate seen = test::seen(scene, view, 100'000 / (nsamp + 3));
                EXPECT_NEAR(seen.mean, expected, 4 * seen.error);
                EXPECT_LT(seen.error, 0.025 * expected) << "too noisy to say anything";
                for (const test::Estimate& other : all) test::expect_same(seen, other);
                all.push_back(seen);
            }
    }
}

// A panel where the mirror direction of `view` goes, facing the plate.
std::string panel(const std::string& light) {
    return light + "\npanel polygon panel 0 0 12 -1.2 -1 1 -1.2 .4 1 0 .4 1 0 -1 1\n";
}

// A source is sampled directly, or found by lobe and ambient rays; either way all of it counts, once.
TEST(NrlBrdf, CountsALightOnceWhetherSampledOrMet) {
    const test::TemporaryFolder folder;
    RenderSettings settings = test::bounce_settings(16);
    settings.source_jitter = 1;
    for (const auto& file : test::write_tables(folder)) {
        SCOPED_TRACE(file.name);
        const std::string plate = plate_of(file, 16, 0.2);
        const auto seen = [&](const std::string& light) {
            test::TracedScene scene(plate + panel(light), settings);
            return test::seen(scene, view, 4000);
        };
        const test::Estimate sampled = seen("void light panel 0 0 3 5 5 5");
        EXPECT_LT(sampled.error, 0.01 * sampled.mean);
        test::expect_same(sampled, seen("void glow panel 0 0 4 5 5 5 0"));
        test::expect_same(sampled, seen("void glow panel 0 0 4 5 5 5 10"));
        test::expect_same(sampled, seen("void glow panel 0 0 4 5 5 5 .3"));  // out of its reach
        test::expect_same(sampled, seen("void emissive panel 0 0 3 5 5 5"));
        test::expect_same(sampled, seen("void emissive panel 0 0 4 5 5 5 10"));
    }
}

TEST(NrlBrdf, ItsEmissionIsThatOfAnEmissiveAroundIt) {
    const test::TemporaryFolder folder;
    const auto file = test::write_tables(folder).front();
    test::TracedScene own(
        words("void nrlbrdf m 1", file.path, "0 8 .9 .8 .7 4 .2 3 2 1", test::plate, sky_with_spot()),
        test::bounce_settings(16));
    test::TracedScene wrapped(
        words("void nrlbrdf skin 1", file.path, "0 5 .9 .8 .7 4 .2\nvoid emissive m 1 skin 0 3 3 2 1",
              test::plate, sky_with_spot()),
        test::bounce_settings(16));
    for (int n = 0; n < 20; ++n) {
        const Spectrum a = own.radiance(view.origin, view.direction);
        const Spectrum b = wrapped.radiance(view.origin, view.direction);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(a[c], b[c]);
    }
}

TEST(NrlBrdf, PatternsAndColorScaleTheTable) {
    const test::TemporaryFolder folder;
    const auto file = test::write_tables(folder).front();
    test::TracedScene scene(words("void brightfunc half 2 .5 . 0 0\nhalf nrlbrdf m 1", file.path,
                                  "0 5 1 .5 0 64 .2", test::plate, test::surrounding(2)),
                            test::bounce_settings(16));
    const double full = 2 * 0.5 * file.table->reflectance_dh(-view.direction.z);
    test::Mean red, green;
    for (int n = 0; n < 2000; ++n) {
        const Spectrum value = scene.radiance(view.origin, view.direction);
        red.add(static_cast<double>(value[0]));
        green.add(static_cast<double>(value[1]));
        EXPECT_EQ(value[2], 0.0f);
    }
    test::expect_close(red.estimate(), full, 2e-3);
    test::expect_close(green.estimate(), 0.5 * full, 2e-3);
}

}  // namespace
}  // namespace infra
