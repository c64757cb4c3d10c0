#include "ir/genirsky/sea_plane.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "common/error.h"
#include "common/format.h"
#include "common/vec.h"
#include "ir/genirsky/sea_grid.h"

namespace infra::ir {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double earth_radius = 6.371e6;  // m, the mean

/// The radiance of the point whose direction is nearest. `direction` has unit length, z upwards.
double nearest_in_direction(const std::vector<SeaPoint>& points, const Sensor& sensor,
                            const Vec3& direction) {
    double best = -2, radiance = 0;
    for (const SeaPoint& point : points) {
        const Vec3 towards = normalize(Vec3{point.x - sensor.x, point.y - sensor.y, -sensor.height});
        const double cosine = dot(towards, direction);
        if (cosine <= best) continue;
        best = cosine;
        radiance = point.radiance;
    }
    return radiance;
}

}  // namespace

std::vector<SeaPoint> parse_sea_points(const NumberText& text, const ValueReader& reader) {
    std::vector<SeaPoint> points;
    for (const NumberLine& line : text.lines) {
        if (line.size() != 3)
            throw Error(Location{text.name, line[0].line}, formatted("found %zu numbers", line.size()),
                        "a line is x, y and a value");
        points.push_back({line[0].value, line[1].value, reader.radiance(line[2], text)});
    }
    return points;
}

Dome project_sea(const std::vector<SeaPoint>& points, const Sensor& sensor, double handedness) {
    const std::optional<SeaGrid> grid = SeaGrid::find(points);
    Dome dome;
    for (std::size_t column = 0; column < Dome::columns; ++column) {
        const double azimuth = Dome::azimuth_deg(column % (Dome::columns - 1)) * degree;
        const double east = std::cos(azimuth), north = handedness * std::sin(azimuth);
        for (std::size_t row = 0; row < Dome::rows; ++row) {
            const double nadir = Dome::angle_deg(row) * degree;
            const bool horizon = row == Dome::rows - 1;
            const double distance =
                horizon ? std::sqrt(2 * earth_radius * sensor.height) : sensor.height * std::tan(nadir);
            std::optional<double> value;
            if (grid) value = grid->at(sensor.x + distance * east, sensor.y + distance * north);
            const double across = std::sin(nadir), down = -std::cos(nadir);
            dome.values.push_back(
                value ? *value : nearest_in_direction(points, sensor, {across * east, across * north, down}));
        }
    }
    return dome;
}

}  // namespace infra::ir
