// Does a triangle touch a cubic cell? By RADIANCE's rule to its tolerances, so that our meshes are its meshes
// byte by byte.
#pragma once

#include <array>

#include "scene/octree.h"

namespace infra {

/// The 8 octants of a cell for one triangle after another.
class OctantOverlap {
  public:
    explicit OctantOverlap(const Cube& cell);

    /// Bit i is set if the triangle touches octant i. Its first corner comes first in the tests of edges, so
    /// that corners in another order may give another answer within 1e-6 of a face.
    unsigned operator()(const std::array<Vec3, 3>& corners) const;

  private:
    /// An octant's extent along one axis: the planes, and how far beyond them a point still counts as inside.
    struct Slab {
        double low, high;
        double outside_low, outside_high;
    };
    struct Octant;

    /// Corners below and above a slab, by bits.
    struct Sides {
        unsigned below, above;
    };

    static bool crosses(const std::array<Vec3, 3>& corners, const Octant& octant);

    Slab slabs_[3][2];  // by axis, lower and upper half
};

}  // namespace infra
