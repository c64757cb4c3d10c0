#include "ir/genirsky/frame.h"

#include <cmath>
#include <numbers>

#include "common/format.h"

namespace infra::ir {

Vec3 Frame::direction(double altitude_deg, double azimuth_deg) const {
    constexpr double degree = std::numbers::pi / 180;
    const double altitude = altitude_deg * degree, around = (turn_deg - azimuth_deg) * degree;
    const double x = std::cos(altitude) * std::cos(around), y = std::cos(altitude) * std::sin(around);
    return y_up ? Vec3{x, std::sin(altitude), -y} : Vec3{x, y, std::sin(altitude)};
}

std::vector<std::string> Frame::transform() const {
    std::vector<std::string> words;
    if (!y_up) words = {"-rx", "90"};
    if (turn_deg != 0) words.insert(words.end(), {y_up ? "-ry" : "-rz", formatted("%.9g", turn_deg)});
    return words;
}

}  // namespace infra::ir
