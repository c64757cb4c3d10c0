// Interpolation of values at scattered points in three dimensions: exact at the points, never beyond them.
//
// Shepard's method with nodal slopes: every point carries the plane that fits its neighbours best (weighted
// least squares through its own value), and the planes of the nearest points are blended with weights
// ((R - d) / (R d))^2 that are infinite at the point and fade at the neighbourhood's edge R. The result is
// then kept between the smallest and the largest of the values that take part: it cannot overshoot, and a
// constant stays that constant.
//   source  Franke and Nielson, "Smooth Interpolation of Large Sets of Scattered Data", Int. J. Numer. Meth.
//           Eng. 15 (1980) 1691; Renka, ACM TOMS 14 (1988) 139. The bounds are ours.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ir/brdftab/neighbours.h"

namespace infra::ir {

class Shepard {
  public:
    enum class Slopes {
        none,     ///< blend the values alone
        bounded,  ///< blend the planes, within the range of the values taking part
        open      ///< blend the planes, within the range of all values
    };

    /// shape: N different points, N values, N >= 1.
    Shepard(std::vector<Point3> points, std::vector<double> values);

    double eval(const Point3& at, Slopes slopes) const;

    /// What the others say at the n-th point: neither its value nor a plane that it shaped is used.
    ///   needs  N >= 2
    double predict_without(std::size_t n) const;

  private:
    Point3 slope(std::size_t n, std::optional<std::size_t> without) const;
    double blend(const Point3& at, const std::vector<Neighbour>& near, Slopes slopes,
                 std::optional<std::size_t> without) const;

    NeighbourSearch search_;
    std::vector<double> values_;
    std::vector<std::vector<Neighbour>> around_;  // of every point, itself left out
    std::vector<Point3> slopes_;
    double smallest_, largest_;
};

}  // namespace infra::ir
