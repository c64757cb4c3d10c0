// The sea's plane seen from a sensor.
#include "ir/genirsky/sea_plane.h"

#include <numbers>

#include "fixtures.h"
#include "ir/genirsky/sea_grid.h"

namespace infra::ir {
namespace {

using test::error_of;

constexpr double degree = std::numbers::pi / 180;

double linear(double x, double y) { return 30 + .02 * x - .01 * y; }

/// A grid of uneven spacing from -size to size, in an order of its own.
std::vector<SeaPoint> grid_points(double size) {
    std::vector<SeaPoint> points;
    for (const double x : {1., -.3, -1., .4})
        for (const double y : {-1., 1., .1})
            points.push_back({size * x, size * y, linear(size * x, size * y)});
    return points;
}

TEST(SeaGrid, FindsGridsInAnyOrder) {
    const auto grid = SeaGrid::find(grid_points(100));
    ASSERT_TRUE(grid);
    EXPECT_NEAR(*grid->at(12, -34), linear(12, -34), 1e-12);
    EXPECT_NEAR(*grid->at(100, 100), linear(100, 100), 1e-12);
    EXPECT_NEAR(*grid->at(-100, -100), linear(-100, -100), 1e-12);
    EXPECT_FALSE(grid->at(100.1, 0));
    std::vector<SeaPoint> scattered = grid_points(100);
    scattered[3].x += 1;
    EXPECT_FALSE(SeaGrid::find(scattered));
    EXPECT_FALSE(SeaGrid::find({{0, 0, 1}}));
    EXPECT_FALSE(SeaGrid::find({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}));
}

// A plane radiance on a grid that reaches beyond the horizon: every node has the value of its point of the
// sea.
TEST(SeaPlane, ProjectsAGrid) {
    const Sensor sensor{.height = 10, .x = 5, .y = -3};
    for (const Frame& frame : {Frame{}, Frame{.turn_deg = 30}, Frame{.y_up = true, .turn_deg = -100}}) {
        const double handedness = frame.y_up ? 1 : -1;
        const Dome dome = project_sea(grid_points(2e4), sensor, frame);
        ASSERT_EQ(dome.values.size(), 210u);
        for (int column = 0; column <= 20; ++column)
            for (int row = 0; row < 10; ++row) {
                const double distance =
                    row == 9 ? std::sqrt(2 * 6.371e6 * 10) : 10 * std::tan(10 * row * degree);
                const double azimuth = (18 * column - frame.turn_deg) * degree;
                const double x = 5 + distance * std::cos(azimuth),
                             y = -3 + handedness * distance * std::sin(azimuth);
                EXPECT_NEAR(dome.values[static_cast<std::size_t>(10 * column + row)], linear(x, y), 1e-9)
                    << column << ' ' << row;
            }
    }
}

// Points on the nodes themselves, in no grid: each is its own node's nearest.
TEST(SeaPlane, TakesTheNearestOfScatteredPoints) {
    const Sensor sensor{.height = 3, .x = 1, .y = 2};
    std::vector<SeaPoint> points;
    for (int column = 0; column < 20; ++column)
        for (int row = column == 0 ? 0 : 1; row < 9; ++row) {
            const double distance = 3 * std::tan(10 * row * degree), azimuth = 18 * column * degree;
            points.push_back({1 + distance * std::cos(azimuth), 2 + distance * std::sin(azimuth),
                              row == 0 ? 1 : 10. * column + row});
        }
    const Dome dome = project_sea(points, sensor, {.y_up = true});
    for (int column = 0; column <= 20; ++column)
        for (int row = 0; row < 10; ++row)
            EXPECT_EQ(dome.values[static_cast<std::size_t>(10 * column + row)],
                      row == 0 ? 1 : 10. * (column % 20) + std::min(row, 8))
                << column << ' ' << row;
}

TEST(SeaPlane, ReadsPoints) {
    const ValueReader reader(ValueUnit::radiance, nullptr);
    const auto points = parse_sea_points(parse_numbers("0 1 34\n-2 3 35\n", "sea"), reader);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1].x, -2);
    EXPECT_EQ(points[1].radiance, 35);
    EXPECT_EQ(error_of([&] { parse_sea_points(parse_numbers("0 1 34\n0 2\n", "sea"), reader); }),
              "sea:2: found 2 numbers (a line is x, y and a value)");
}

TEST(SeaPlane, HasOneValueAtAPlace) {
    const ValueReader reader(ValueUnit::radiance, nullptr);
    const std::string grid = "0 0 34\n0 1 35\n1 0 36\n1 1 37\n";
    const auto points = parse_sea_points(parse_numbers(grid + "0 1 35\n", "sea"), reader);
    EXPECT_TRUE(SeaGrid::find(points));
    EXPECT_EQ(error_of([&] { parse_sea_points(parse_numbers(grid + "0 1 36\n", "sea"), reader); }),
              "sea:5:1: line 2 has another value at 0 1");
}

}  // namespace
}  // namespace infra::ir
