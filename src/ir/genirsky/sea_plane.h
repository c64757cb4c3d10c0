// Radiances of points on the sea, seen from a sensor above it, as a hemisphere of directions.
#pragma once

#include <vector>

#include "ir/genirsky/dome.h"
#include "ir/genirsky/dome_file.h"

namespace infra::ir {

/// A point of the sea: coordinates of the scene, metres, and the radiance that it sends to the sensor.
struct SeaPoint {
    double x = 0, y = 0;
    double radiance = 0;  ///< W m^-2 sr^-1
};

/// Lines of x, y and a value. throws Error as ValueReader, and for lines of another form.
std::vector<SeaPoint> parse_sea_points(const NumberText& text, const ValueReader& reader);

struct Sensor {
    double height = 0;  ///< above the sea, metres, > 0
    double x = 0, y = 0;
};

/// The nodes of lib/skyfuncs/hemisea.cal. A node's direction meets the sea at height times the tangent of its
/// nadir angle. Where the points form a rectangular grid, the value there is bilinear between them; beyond
/// the grid, and for scattered points everywhere, it is that of the point whose direction, seen from the
/// sensor, is nearest. The row at 90 deg stands for the visible horizon, sqrt(2 R height) away on an earth of
/// radius R.
///   handedness  +1: azimuth runs from +x to +y of the points, -1: from +x to -y
Dome project_sea(const std::vector<SeaPoint>& points, const Sensor& sensor, double handedness);

}  // namespace infra::ir
