// Skies and seas as a scene shows them: function files on glowing sources. (What the functions give is tested
// in tests/cal/sky_test.cpp.)
#include <gtest/gtest.h>

#include <vector>

#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
using test::words;

constexpr double single_precision = 2e-5;

/// From the angle to the pole and the azimuth, in degrees, with y up as the function files have it.
Vec3 y_up(double from_pole, double azimuth) {
    const Vec3 d = test::direction(from_pole * degree, azimuth * degree);
    return {d.x, d.z, d.y};
}

double node(int column, int row) { return row == 0 ? 5 : 1 + (column % 20 * 37 + row * 13) % 19; }

std::string samples() {
    std::string text = "0 210 ";
    for (int column = 0; column <= 20; ++column)
        for (int row = 0; row < 10; ++row) text += words(node(column, row));
    return text;
}

const std::string sky = "void brightfunc sky_pattern 2 skybr skyfuncs/hemisky.cal " + samples() +
                        "\nsky_pattern glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 1 0 180\n";
const std::string sea = "void brightfunc sea_pattern 2 seabr skyfuncs/hemisea.cal " + samples() +
                        "\nsea_pattern glow sea_glow 0 0 4 1 1 1 0\nsea_glow source sea 0 0 4 0 -1 0 180\n";

double radiance(test::TracedScene& scene, const Vec3& direction) {
    return static_cast<double>(scene.radiance({10, 20, 30}, direction)[0]);
}

TEST(Sky, ShowsEveryNodeOfSkyAndSea) {
    test::TracedScene scene(sky + sea);
    for (int column = 0; column <= 20; ++column)
        for (int row = 0; row < 9; ++row) {
            const Vec3 up = y_up(10 * row, 18 * column);
            EXPECT_NEAR(radiance(scene, up), node(column, row), single_precision) << column << ' ' << row;
            EXPECT_NEAR(radiance(scene, {up.x, -up.y, up.z}), node(column, row), single_precision)
                << column << ' ' << row;
        }
}

TEST(Sky, MeetsTheSeaWithoutAGapOrStep) {
    test::TracedScene scene(sky + sea);
    for (int column = 0; column <= 20; ++column)
        for (const double below : {0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6})
            EXPECT_NEAR(radiance(scene, y_up(90 + below, 18 * column)), node(column, 9), 1e-4)
                << column << ", " << below << " deg below the horizon";
}

TEST(Sky, IsTurnedByATransform) {
    const std::string transforms[] = {"-rx 90", "-rx 90 -rz 36"};
    for (const std::string& transform : transforms) {
        const double turned = transform.size() > 6 ? 36 : 0;
        test::TracedScene scene(words(
            "void brightfunc sky_pattern", turned > 0 ? 6 : 4, "skybr skyfuncs/hemisky.cal", transform,
            samples(), "\nsky_pattern glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180\n"));
        for (int column = 0; column < 20; ++column) {
            const Vec3 d = y_up(40, 18 * column);
            const Vec3 z_up{d.x, -d.z, d.y};
            const double c = std::cos(turned * degree), s = std::sin(turned * degree);
            EXPECT_NEAR(radiance(scene, {c * z_up.x - s * z_up.y, s * z_up.x + c * z_up.y, z_up.z}),
                        node(column, 4), single_precision)
                << transform << ' ' << column;
        }
    }
}

// Irradiance of level ground under ten samples: by quadrature in the angle alone.
TEST(Sky, LightsTheGround) {
    const std::vector<double> ten = {20, 21, 19, 25, 30, 28, 26, 33, 40, 38};
    std::string text = "void brightfunc p 2 skybr skyfuncs/elevsky.cal 0 10 ";
    for (const double value : ten) text += words(value);
    test::TracedScene scene(text + "\np glow g 0 0 4 1 1 1 0\ng source s 0 0 4 0 1 0 180\n",
                            test::bounce_settings(4096));
    double expected = 0;
    constexpr int steps = 9000;
    for (int n = 0; n < steps; ++n) {
        const double theta = 90 * degree * (n + 0.5) / steps, place = 9.0 * (n + 0.5) / steps;
        const auto row = static_cast<std::size_t>(place);
        const double between = place - static_cast<double>(row);
        const double value = (1 - between) * ten[row] + between * ten[row + 1];
        expected += 2 * std::numbers::pi * value * std::cos(theta) * std::sin(theta) * 90 * degree / steps;
    }
    test::expect_close(scene.mean_irradiance(50,
                                             [](RandomStream&) {
                                                 return test::RaySpec{{0, 0, 0}, {0, 1, 0}};
                                             }),
                       expected, 1e-3);
}

}  // namespace
}  // namespace infra
