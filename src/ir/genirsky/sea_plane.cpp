#include "ir/genirsky/sea_plane.h"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

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

/// Points of different places. throws Error for two values at one place, with the later one's line
class DistinctPoints {
  public:
    explicit DistinctPoints(const NumberText& text) : text_(text) {}

    void add(const SeaPoint& point, const PlacedNumber& first) {
        const auto [known, is_new] =
            places_.try_emplace({point.x, point.y}, Known{first.line, point.radiance});
        if (is_new) {
            points_.push_back(point);
        } else if (known->second.radiance != point.radiance) {
            throw Error(text_.place(first), formatted("line %d has another value at %g %g",
                                                      known->second.line, point.x, point.y));
        }
    }
    std::vector<SeaPoint> take() { return std::move(points_); }

  private:
    struct Known {
        int line;
        double radiance;
    };
    const NumberText& text_;
    std::map<std::pair<double, double>, Known> places_;
    std::vector<SeaPoint> points_;
};

}  // namespace

std::vector<SeaPoint> parse_sea_points(const NumberText& text, const ValueReader& reader) {
    DistinctPoints points(text);
    for (const NumberLine& line : text.lines) {
        if (line.size() != 3)
            throw Error(Location{text.name, line[0].line}, formatted("found %zu numbers", line.size()),
                        "a line is x, y and a value");
        points.add({line[0].value, line[1].value, reader.radiance(line[2], text)}, line[0]);
    }
    return points.take();
}

Dome project_sea(const std::vector<SeaPoint>& points, const Sensor& sensor, const Frame& frame) {
    const std::optional<SeaGrid> grid = SeaGrid::find(points);
    Dome dome;
    for (std::size_t column = 0; column < Dome::columns; ++column) {
        const Vec3 outwards = frame.direction(0, Dome::azimuth_deg(column % (Dome::columns - 1)));
        const double along_x = outwards.x, along_y = frame.y_up ? outwards.z : outwards.y;
        for (std::size_t row = 0; row < Dome::rows; ++row) {
            const double nadir = Dome::angle_deg(row) * degree;
            const bool horizon = row == Dome::rows - 1;
            const double distance =
                horizon ? std::sqrt(2 * earth_radius * sensor.height) : sensor.height * std::tan(nadir);
            std::optional<double> value;
            if (grid) value = grid->at(sensor.x + distance * along_x, sensor.y + distance * along_y);
            const double across = std::sin(nadir), down = -std::cos(nadir);
            dome.values.push_back(
                value ? *value
                      : nearest_in_direction(points, sensor, {across * along_x, across * along_y, down}));
        }
    }
    return dome;
}

}  // namespace infra::ir
