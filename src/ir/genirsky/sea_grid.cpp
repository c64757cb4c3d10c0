#include "ir/genirsky/sea_grid.h"

#include <algorithm>
#include <limits>

namespace infra::ir {
namespace {

std::vector<double> distinct(const std::vector<SeaPoint>& points, double SeaPoint::*coordinate) {
    std::vector<double> values;
    for (const SeaPoint& point : points) values.push_back(point.*coordinate);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_of(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

/// The cell that holds a value, as a place among its corners and a part 0..1; nothing outside.
struct Cell {
    std::size_t first = 0;
    double part = 0;
};
std::optional<Cell> cell_of(const std::vector<double>& corners, double value) {
    if (!(value >= corners.front() && value <= corners.back())) return std::nullopt;
    const std::size_t last = std::clamp<std::size_t>(place_of(corners, value), 1, corners.size() - 1);
    return Cell{last - 1, (value - corners[last - 1]) / (corners[last] - corners[last - 1])};
}

}  // namespace

std::optional<SeaGrid> SeaGrid::find(const std::vector<SeaPoint>& points) {
    constexpr double absent = std::numeric_limits<double>::infinity();
    SeaGrid grid;
    grid.x_ = distinct(points, &SeaPoint::x);
    grid.y_ = distinct(points, &SeaPoint::y);
    if (grid.x_.size() < 2 || grid.y_.size() < 2) return std::nullopt;
    if (grid.x_.size() * grid.y_.size() != points.size()) return std::nullopt;
    grid.values_.assign(points.size(), absent);
    for (const SeaPoint& point : points)
        grid.values_[place_of(grid.y_, point.y) * grid.x_.size() + place_of(grid.x_, point.x)] =
            point.radiance;
    if (std::ranges::count(grid.values_, absent) > 0) return std::nullopt;
    return grid;
}

std::optional<double> SeaGrid::at(double x, double y) const {
    const std::optional<Cell> column = cell_of(x_, x), row = cell_of(y_, y);
    if (!column || !row) return std::nullopt;
    const auto along = [&](std::size_t line) {
        const double* values = &values_[line * x_.size() + column->first];
        return values[0] + column->part * (values[1] - values[0]);
    };
    const double below = along(row->first), above = along(row->first + 1);
    return below + row->part * (above - below);
}

}  // namespace infra::ir
