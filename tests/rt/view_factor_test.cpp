// VALIDATION V5, view factors from Howell's catalogue as irradiance from a surface of radiance 1, over pi.
#include <gtest/gtest.h>

#include <numbers>

#include "scene_pieces.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double bar = 1e-3;
const std::string emitter = "void emissive e 0 0 3 1 1 1\n";

RenderSettings settings(int divisions) {
    RenderSettings s = test::bounce_settings(divisions);
    s.min_weight = 1e-12;
    return s;
}

// Mean irradiance over the receiver, place(u, v) for stratified points of the unit square; from independent
// repetitions, because stratified values say nothing of the error of their mean.
template <class Place>
test::Estimate view_factor(const std::string& source, int divisions, int grid, const Place& place) {
    constexpr int repetitions = 16;
    test::TracedScene scene(emitter + source, settings(divisions));
    test::Mean factor;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        int n = 0;
        const test::Estimate irradiance = scene.mean_irradiance(grid * grid, [&](RandomStream& random) {
            const double u = (n % grid + random.uniform()) / grid;
            const double v = (n / grid + random.uniform()) / grid;
            ++n;
            return place(u, v);
        });
        factor.add(irradiance.mean / pi);
    }
    return factor.estimate();
}

test::RaySpec on_disk(double radius, double u, double v) {
    const double r = radius * std::sqrt(u);
    return {{r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), 0}, {0, 0, 1}};
}

TEST(ViewFactor, FacesOfACube) {
    const auto on_floor = [](double u, double v) { return test::RaySpec{{u, v, 0}, {0, 0, 1}}; };
    test::expect_close(view_factor("e polygon top 0 0 12 0 0 1 0 1 1 1 1 1 1 0 1\n", 1024, 20, on_floor),
                       0.199825, bar);
    test::expect_close(view_factor("e polygon side 0 0 12 0 0 0 0 1 0 0 1 1 0 0 1\n", 1024, 32, on_floor),
                       0.200044, bar);
}

TEST(ViewFactor, CoaxialDisks) {
    test::expect_close(view_factor("e ring r 0 0 8 0 0 1 0 0 -1 0 1\n", 1024, 20,
                                   [](double u, double v) { return on_disk(1, u, v); }),
                       0.381966, bar);
    test::expect_close(view_factor("e ring r 0 0 8 0 0 1 0 0 -1 0 2\n", 1024, 16,
                                   [](double u, double v) { return on_disk(1, u, v); }),
                       0.763932, bar);
}

TEST(ViewFactor, FromAnElement) {
    const auto element = [](double, double) { return test::RaySpec{{0, 0, 0}, {0, 0, 1}}; };
    test::expect_close(view_factor("e ring r 0 0 8 0 0 2 0 0 -1 0 1\n", 16384, 4, element), 0.2, bar);
    test::expect_close(view_factor("e polygon p 0 0 12 0 0 1 0 1 1 1 1 1 1 0 1\n", 16384, 4, element),
                       0.138532, bar);
}

}  // namespace
}  // namespace infra
