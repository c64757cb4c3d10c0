// Does a surface touch a cubic cell? Never says no to one that does; may say yes to a near miss.
#pragma once

#include <vector>

#include "scene/instance_box.h"
#include "scene/octree.h"
#include "scene/scene.h"

namespace infra {

enum class Overlap {
    none,
    partial,
    contained,  ///< the whole cell lies inside a volume (instance, mesh)
};

class CellOverlap {
  public:
    /// `smallest`: size of the smallest cell that will be asked for.
    CellOverlap(const Scene& scene, InstanceBoxes& instances, double smallest)
        : scene_(scene), instances_(instances), smallest_(smallest) {}

    /// The surface must be usable (check_surface).
    Overlap operator()(PrimitiveId id, const Cube& cell);

  private:
    bool polygon(std::span<const double> corners, const Cube& cell);
    bool clipped_polygon_remains(std::span<const double> corners, const Cube& cell);

    const Scene& scene_;
    InstanceBoxes& instances_;
    double smallest_;
    std::vector<Vec3> clipped_, clipping_;
};

}  // namespace infra
