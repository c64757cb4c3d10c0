// lib/skyfuncs as a glow shows them: exact at every node, linear between, continuous everywhere.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
using test::words;

constexpr double exact = 1e-5;  // single precision and the rounding of an angle, relative to values up to 20

/// Y is up in these files.
Vec3 y_up(double from_pole_deg, double azimuth_deg) {
    const Vec3 d = test::direction(from_pole_deg * degree, azimuth_deg * degree);
    return {d.x, d.z, d.y};
}

/// Values without any pattern, one line of ten for each azimuth; the last repeats the first.
double node(int column, int row) {
    return 1 + ((column % 20) * 37 + row * 13) % 19 + 0.01 * (row == 0 ? 0 : column % 20);
}
double pole() { return 5; }

std::vector<double> hemisphere_values() {
    std::vector<double> values;
    for (int r = 0; r <= 20; ++r)
        for (int h = 0; h < 10; ++h) values.push_back(h == 0 ? pole() : node(r, h));
    return values;
}

class Sky {
  public:
    Sky(const std::string& function, const std::string& file, const std::vector<double>& values,
        const std::string& source, const std::string& transform = "")
        : scene_(text(function, file, values, source, transform)) {}

    double operator()(const Vec3& d) { return static_cast<double>(scene_.radiance({1, 2, 3}, d)[0]); }

  private:
    static std::string text(const std::string& function, const std::string& file,
                            const std::vector<double>& values, const std::string& source,
                            const std::string& transform) {
        std::string rad = words("void brightfunc pattern", transform.empty() ? 2 : 4, function, file,
                                transform, "0", values.size());
        for (const double v : values) rad += words(v);
        return rad + "\npattern glow sky 0 0 4 1 1 1 0\nsky source s 0 0 4 " + source + "\n";
    }
    test::TracedScene scene_;
};

Sky hemisky() { return {"skybr", "skyfuncs/hemisky.cal", hemisphere_values(), "0 1 0 180"}; }
Sky hemisea() { return {"seabr", "skyfuncs/hemisea.cal", hemisphere_values(), "0 -1 0 180"}; }

void expect_nodes(Sky sky, double side) {
    for (int r = 0; r <= 20; ++r)
        for (int h = 1; h < 10; ++h) {
            const Vec3 d = y_up(10 * h, 18 * r);
            EXPECT_NEAR(sky({d.x, std::fabs(d.y) * side, d.z}), node(r, h), 20 * exact)
                << "r " << r << ", h " << h;
        }
    EXPECT_NEAR(sky({0, side, 0}), pole(), exact);
}

TEST(SkyFunctions, HemispheresAreExactAtEveryNode) {
    expect_nodes(hemisky(), 1);
    expect_nodes(hemisea(), -1);
}

TEST(SkyFunctions, ElevationTableIsExactAtEveryNodeAndLinearBetween) {
    std::vector<double> values;
    for (int h = 0; h < 10; ++h) values.push_back(node(3, h));
    Sky sky("skybr", "skyfuncs/elevsky.cal", values, "0 1 0 180");
    for (int h = 0; h < 10; ++h)
        for (const double azimuth : {0.0, 90.0, 123.0, 180.0, 359.0}) {
            EXPECT_NEAR(sky(y_up(10 * h, azimuth)), node(3, h), 20 * exact) << h;
            if (h == 9) continue;
            EXPECT_NEAR(sky(y_up(10 * h + 2.5, azimuth)), 0.75 * node(3, h) + 0.25 * node(3, h + 1),
                        20 * exact);
        }
}

TEST(SkyFunctions, HemispheresAreBilinearBetweenNodes) {
    Sky sky = hemisky();
    for (int r = 0; r < 20; ++r)
        for (int h = 1; h < 9; ++h) {
            const double low = 0.75 * node(r, h) + 0.25 * node(r + 1, h);
            const double high = 0.75 * node(r, h + 1) + 0.25 * node(r + 1, h + 1);
            EXPECT_NEAR(sky(y_up(10 * h + 4, 18 * r + 4.5)), 0.6 * low + 0.4 * high, 20 * exact);
        }
}

// No step across lines of nodes, the azimuth seam, the pole or the horizon: two directions 1e-5 degrees apart
// are alike.
void expect_continuous(Sky sky, double side) {
    constexpr double apart = 1e-5, steepest = 20 / 1.8;  // degrees; per degree, near the pole more
    const auto value = [&](double from_pole, double azimuth) {
        const Vec3 d = y_up(from_pole, azimuth);
        return sky({d.x, d.y * side, d.z});
    };
    for (int h = 1; h < 9; ++h)
        for (double azimuth = 0; azimuth < 360; azimuth += 4.5)
            EXPECT_NEAR(value(10 * h - apart, azimuth), value(10 * h + apart, azimuth),
                        2 * apart * steepest + 20 * exact);
    for (int r = 0; r < 20; ++r)
        for (double from_pole = 0.5; from_pole < 90; from_pole += 4.5)
            EXPECT_NEAR(value(from_pole, 18 * r - apart), value(from_pole, 18 * r + apart),
                        2 * apart * steepest + 20 * exact);
    for (double azimuth = 0; azimuth < 360; azimuth += 4.5) {
        EXPECT_NEAR(value(apart, azimuth), pole(), 1e-3);
        EXPECT_NEAR(value(90 - apart, azimuth), value(90, azimuth), 1e-3);
    }
}

TEST(SkyFunctions, HemispheresHaveNoSteps) {
    expect_continuous(hemisky(), 1);
    expect_continuous(hemisea(), -1);
}

TEST(SkyFunctions, AreTurnedZUpByATransform) {
    Sky sky("skybr", "skyfuncs/hemisky.cal", hemisphere_values(), "0 0 1 180", "-rx 90");
    // -rx 90 takes y to z and z to -y
    for (int r = 0; r < 20; ++r) {
        const Vec3 d = y_up(40, 18 * r);
        EXPECT_NEAR(sky({d.x, -d.z, d.y}), node(r, 4), 20 * exact) << r;
    }
}

}  // namespace
}  // namespace infra
