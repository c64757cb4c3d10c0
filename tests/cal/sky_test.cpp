// The sky and sea tables of lib/skyfuncs: right at every node, linear between, continuous everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "common/vec.h"
#include "evaluate.h"

namespace infra::cal {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Unit vector by angle from the vertical (+y) and azimuth (from +x towards +z), in degrees.
Vec3 direction(double zenith, double azimuth) {
    const double z = zenith * degree, a = azimuth * degree;
    return {std::sin(z) * std::cos(a), std::cos(z), std::sin(z) * std::sin(a)};
}

/// A function file over a table of real arguments.
class Table {
  public:
    Table(const char* file, const char* function, std::vector<double> values) : values_(std::move(values)) {
        Library library = make_ray_library();
        const std::string context = library.load_function_file(file, {});
        function_ = library.compile(function, {}, context);
        evaluator_.emplace(library.link());
    }

    double operator()(const Vec3& d) {
        Host host;
        host.self = &d;
        host.channel = [](const void* self, int number) {
            return (*static_cast<const Vec3*>(self))[number - ray_direction];
        };
        host.reals = values_;
        evaluator_->next_clock();
        return evaluator_->evaluate(function_, host);
    }

    double at(int r, int h) const { return values_[static_cast<std::size_t>(10 * r + h)]; }

  private:
    std::vector<double> values_;
    ExprId function_;
    std::optional<Evaluator> evaluator_;
};

std::vector<double> ten_values() { return {20, 21, 19, 25, 30, 28, 26, 33, 40, 38}; }

/// Values without pattern, the same at the zenith for every azimuth, the last column repeating the first.
std::vector<double> dome_values() {
    std::vector<double> values;
    for (int r = 0; r <= 20; ++r)
        for (int h = 0; h < 10; ++h) values.push_back(h == 0 ? 20. : 20. + (r % 20 * 37 + h * 53) % 29);
    return values;
}

constexpr double rounding = 1e-11;  // of the angles, times slopes of some units a degree

TEST(ElevationSky, IsExactAtItsNodesAndLinearBetween) {
    Table sky("skyfuncs/elevsky.cal", "skybr", ten_values());
    for (int h = 0; h < 10; ++h) EXPECT_NEAR(sky(direction(10. * h, 77)), sky.at(0, h), rounding) << h;
    for (int h = 0; h < 9; ++h)
        EXPECT_NEAR(sky(direction(10. * h + 2.5, 200)), .75 * sky.at(0, h) + .25 * sky.at(0, h + 1), rounding)
            << h;
}

TEST(ElevationSky, StaysAtTheHorizonsValueBelow) {
    Table sky("skyfuncs/elevsky.cal", "skybr", ten_values());
    for (const double zenith : {90., 91., 135., 180.})
        EXPECT_NEAR(sky(direction(zenith, 10)), sky.at(0, 9), rounding);
    EXPECT_EQ(sky({0, 1, 0}), sky.at(0, 0));
    EXPECT_EQ(sky({0, 1 + 1e-15, 0}), sky.at(0, 0));
}

TEST(HemisphereSky, IsExactAtAll210Nodes) {
    Table sky("skyfuncs/hemisky.cal", "skybr", dome_values());
    for (int r = 0; r <= 20; ++r)
        for (int h = 0; h < 10; ++h)
            EXPECT_NEAR(sky(direction(10. * h, 18. * r)), sky.at(r, h), rounding) << r << ' ' << h;
}

TEST(HemisphereSky, IsBilinearInEveryCell) {
    Table sky("skyfuncs/hemisky.cal", "skybr", dome_values());
    constexpr double u = .3, v = .8;
    for (int r = 0; r < 20; ++r) {
        for (int h = 0; h < 9; ++h) {
            const double near = (1 - v) * sky.at(r, h) + v * sky.at(r, h + 1);
            const double far = (1 - v) * sky.at(r + 1, h) + v * sky.at(r + 1, h + 1);
            EXPECT_NEAR(sky(direction(10 * (h + v), 18 * (r + u))), (1 - u) * near + u * far, rounding)
                << r << ' ' << h;
        }
    }
}

TEST(HemisphereSky, IsContinuousAcrossNodesSeamAndHorizon) {
    Table sky("skyfuncs/hemisky.cal", "skybr", dome_values());
    constexpr double step = 1e-7, jump = 1e-5;  // degrees; slopes are below 5 a degree
    for (int r = 0; r <= 20; ++r) {
        for (double zenith = 1; zenith < 95; zenith += 3.7)
            EXPECT_NEAR(sky(direction(zenith, 18. * r - step)), sky(direction(zenith, 18. * r + step)), jump)
                << r;
        for (int h = 1; h <= 9; ++h)
            EXPECT_NEAR(sky(direction(10. * h - step, 18. * r + 5)),
                        sky(direction(10. * h + step, 18. * r + 5)), jump);
    }
    for (double azimuth = 0; azimuth < 360; azimuth += 13)
        EXPECT_NEAR(sky(direction(1e-7, azimuth)), sky({0, 1, 0}), jump);
}

TEST(HemisphereSky, HasValuesOnTheAxes) {
    Table sky("skyfuncs/hemisky.cal", "skybr", dome_values());
    EXPECT_NEAR(sky({1, 0, 0}), sky.at(0, 9), rounding);
    EXPECT_NEAR(sky({1, 0, -0.}), sky.at(20, 9), rounding);
    EXPECT_NEAR(sky({0, 0, 1}), sky.at(5, 9), rounding);
    EXPECT_NEAR(sky({-1, 0, 0}), sky.at(10, 9), rounding);
    EXPECT_NEAR(sky({-1, 0, -0.}), sky.at(10, 9), rounding);
    EXPECT_NEAR(sky({0, 0, -1}), sky.at(15, 9), rounding);
    EXPECT_NO_THROW(sky({0, -1, 0}));
}

TEST(HemisphereSea, IsTheSkyUpsideDown) {
    Table sea("skyfuncs/hemisea.cal", "seabr", dome_values());
    for (int r = 0; r <= 20; ++r)
        for (int h = 0; h < 10; ++h)
            EXPECT_NEAR(sea(direction(180 - 10. * h, 18. * r)), sea.at(r, h), rounding) << r << ' ' << h;
    EXPECT_NEAR(sea(direction(45, 36)), sea.at(2, 9), rounding);  // above the horizon: its value
}

}  // namespace
}  // namespace infra::cal
