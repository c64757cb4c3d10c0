#include "common/disk_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace infra {
namespace {

constexpr double eighth_turn = std::numbers::pi / 4;

}  // namespace

// The square falls into four triangles that meet in its centre. In each the larger coordinate becomes the
// radius, with its sign, and the ratio of the two an angle from that axis.
Point2 disk_of_square(const Point2& square) {
    const double a = 2 * square[0] - 1, b = 2 * square[1] - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool along_x = std::fabs(a) > std::fabs(b);
    const double radius = along_x ? a : b;
    const double angle = eighth_turn * (along_x ? b / a : a / b);
    const double near = radius * std::cos(angle), across = radius * std::sin(angle);
    return along_x ? Point2{near, across} : Point2{across, near};
}

Point2 square_of_disk(const Point2& disk) {
    const auto [x, y] = disk;
    const double radius = std::sqrt(x * x + y * y);
    const bool along_x = std::fabs(x) > std::fabs(y);
    const double main = along_x ? x : y;
    const double signed_radius = std::copysign(radius, main);
    const double across = main != 0 ? signed_radius * std::atan((along_x ? y : x) / main) / eighth_turn : 0.0;
    const auto into_unit = [](double c) { return std::clamp(0.5 * (c + 1), 0.0, 1 - 0x1p-50); };
    return along_x ? Point2{into_unit(signed_radius), into_unit(across)}
                   : Point2{into_unit(across), into_unit(signed_radius)};
}

}  // namespace infra
