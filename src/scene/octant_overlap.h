// Does a polygon touch a cubic cell? By RADIANCE's rule to its tolerances, so that our octrees and meshes are
// its octrees and meshes byte by byte.
#pragma once

#include <span>

#include "scene/octree.h"

namespace infra {

/// The 8 octants of a cell for one polygon after another.
class OctantOverlap {
  public:
    explicit OctantOverlap(const Cube& cell);

    /// Bit i is set if the polygon touches octant i. It must have an area. Its first corner comes first in
    /// the tests of edges, so that corners in another order may give another answer within 1e-6 of a face.
    unsigned operator()(std::span<const Vec3> corners) const;

  private:
    /// An octant's extent along one axis: the planes, and how far beyond them a point still counts as inside.
    struct Slab {
        double low, high;
        double outside_low, outside_high;
    };
    /// Corners below and above a slab, by bits.
    struct Sides {
        unsigned below, above;
    };
    class Polygon;

    unsigned few_corners(std::span<const Vec3> corners) const;
    unsigned many_corners(std::span<const Vec3> corners) const;

    Slab slabs_[3][2];  // by axis, lower and upper half
};

}  // namespace infra
