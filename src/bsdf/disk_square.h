// The unit square mapped to the unit disk without change of relative areas, in which tensor trees store
// directions: a direction is the point of the disk below it, so that areas are projected solid angles.
//
// source: Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2 (1997).
#pragma once

#include <array>

namespace infra {

using Point2 = std::array<double, 2>;

/// square: 0..1 in both coordinates; the result lies within the unit disk.
Point2 disk_of_square(const Point2& square);

/// disk: within the unit disk; the result lies in 0 <= x < 1, also for points on or, by rounding, beyond the
/// rim.
Point2 square_of_disk(const Point2& disk);

}  // namespace infra
