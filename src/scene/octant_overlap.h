// Does a polygon touch a cubic cell? By RADIANCE's rule to its tolerances, so that our octrees and meshes are
// its octrees and meshes byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/clip_box.h"
#include "scene/octree.h"

namespace infra {

/// The 8 octants of a cell for one polygon after another.
class OctantOverlap {
  public:
    explicit OctantOverlap(const Cube& cell);

    /// Bit i is set if the polygon touches octant i. It must have an area. Its first corner comes first in
    /// the tests of edges, so that corners in another order may give another answer within 1e-6 of a face.
    std::uint8_t operator()(std::span<const Vec3> corners) const;
    std::uint8_t operator()(std::span<const Vec3, 3> corners) const;

  private:
    /// Extents of the lower and the upper half along one axis: the planes, and how far beyond them a point
    /// still counts as inside.
    struct alignas(16) Slabs {
        double low[2], high[2];
        double outside_low[2], outside_high[2];
    };
    /// For each of the six sides of octants a byte: bits of the octants that a point lies beyond on that
    /// side.
    using Sides = std::uint64_t;
    class Polygon;

    /// What tells triangles that lie within one octant, by pairs of axes: xy and yz.
    struct alignas(16) Halves {
        double low[2], high[2];     ///< of the cell, as its octants have it
        double lower[2], upper[2];  ///< less is in the lower half only, more in the upper only
    };

    unsigned octant_around(std::span<const Vec3, 3> corners) const;
    Sides sides_of(const Vec3& p) const;
    ClipBox octant(int branch) const;
    template <std::size_t count>
    unsigned touched(std::span<const Vec3, count> corners) const;

    Slabs slabs_[3];  // by axis
    Halves halves_[2];
};

}  // namespace infra
