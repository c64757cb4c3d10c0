// The nearest points in three dimensions.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace infra::ir {

using Point3 = std::array<double, 3>;

double squared_distance(const Point3& a, const Point3& b);

struct Neighbour {
    double distance2;   ///< squared
    std::size_t index;  ///< into the points
    /// Equal distances are ordered by index, so that the answer is one.
    auto operator<=>(const Neighbour&) const = default;
};

/// A balanced k-d tree, built once.
class NeighbourSearch {
  public:
    explicit NeighbourSearch(std::vector<Point3> points);

    const std::vector<Point3>& points() const { return points_; }

    /// The `count` nearest, or all if there are fewer; nearest first.
    std::vector<Neighbour> nearest(const Point3& to, std::size_t count) const;

  private:
    void build(std::size_t begin, std::size_t end, int axis);
    void visit(std::size_t begin, std::size_t end, int axis, const Point3& to, std::size_t count,
               std::vector<Neighbour>& heap) const;

    std::vector<Point3> points_;
    std::vector<std::size_t> order_;  // the middle of a range splits it
};

}  // namespace infra::ir
