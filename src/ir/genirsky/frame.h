// How the tables' directions stand in the scene.
#pragma once

#include <string>
#include <vector>

#include "common/vec.h"

namespace infra::ir {

/// Azimuth 0 of a table is the scene's +x, turned counter-clockwise, seen from above, by turn_deg; azimuth
/// grows clockwise, as a compass, towards -y (towards +z where y is up).
struct Frame {
    bool y_up = false;
    double turn_deg = 0;

    /// Unit vector of an altitude above the horizon and an azimuth of the table, degrees.
    Vec3 direction(double altitude_deg, double azimuth_deg) const;
    Vec3 up() const { return y_up ? Vec3{0, 1, 0} : Vec3{0, 0, 1}; }
    /// Words of the transform that brings the function files, which have y up, into the scene.
    std::vector<std::string> transform() const;
};

}  // namespace infra::ir
