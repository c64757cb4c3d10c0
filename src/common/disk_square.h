// The unit square mapped to the unit disk without change of relative areas. Seen as the points below directions of a
// hemisphere, areas of the disk are projected solid angles: tensor trees store directions so.
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
