// Radiances of points on the sea, seen from a sensor above it, as a hemisphere of directions.
#pragma once

#include <vector>

#include "ir/genirsky/dome.h"
#include "ir/genirsky/dome_file.h"
#include "ir/genirsky/frame.h"

namespace infra::ir {

/// A point of the sea: the scene's x and y, or x and z where y is up, metres, and the radiance that it sends
/// to the sensor.
struct SeaPoint {
    double x = 0, y = 0;
    double radiance = 0;  ///< W m^-2 sr^-1
};

/// Lines of x, y and a value; a line that repeats another is left out. throws Error as ValueReader, for lines
/// of another form and for two values at one place.
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
///   frame  in which the nodes' azimuths stand among the points
Dome project_sea(const std::vector<SeaPoint>& points, const Sensor& sensor, const Frame& frame);

}  // namespace infra::ir
