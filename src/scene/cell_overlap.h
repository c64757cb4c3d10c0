// Does a surface touch a cubic cell? By RADIANCE's rules to their tolerances, so that oconv's trees are the
// same.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/instance_box.h"
#include "scene/octant_overlap.h"
#include "scene/octree.h"
#include "scene/scene.h"

namespace infra {

enum class Overlap {
    none,
    partial,
    contained,  ///< the whole cell lies inside a volume (instance, mesh)
};

/// For each octant of a cell a bit.
struct OctantBits {
    std::uint8_t touched = 0;    ///< partial or contained
    std::uint8_t contained = 0;  ///< contained

    Overlap operator[](int branch) const {
        if (contained >> branch & 1) return Overlap::contained;
        return touched >> branch & 1 ? Overlap::partial : Overlap::none;
    }
};

class CellOverlap {
  public:
    /// `smallest`: half of a cone's cell is not divided further when it is smaller than this.
    CellOverlap(const Scene& scene, InstanceBoxes& instances, double smallest)
        : scene_(scene), instances_(instances), smallest_(smallest) {}

    /// Which octants of `cell` a surface touches; `polygons` is for the same cell. The surface must be usable
    /// (check_surface).
    OctantBits octants(PrimitiveId id, const Cube& cell, const OctantOverlap& polygons);
    /// The cell as a whole.
    Overlap operator()(PrimitiveId id, const Cube& cell);

    /// The corners of a triangle, as the scene holds them; null for other surfaces.
    const Vec3* triangle(PrimitiveId id) const {
        static_assert(sizeof(Vec3) == 3 * sizeof(double));
        const auto reals = scene_.reals(id);
        const bool is_triangle = scene_.type(id) == PrimitiveType::polygon && reals.size() == 9;
        return is_triangle ? reinterpret_cast<const Vec3*>(reals.data()) : nullptr;
    }

  private:
    const Scene& scene_;
    InstanceBoxes& instances_;
    double smallest_;
    std::vector<Vec3> corners_;
};

}  // namespace infra
