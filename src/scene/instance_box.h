// The cubes that instances and meshes put into a scene.
#pragma once

#include <map>
#include <string>
#include <unordered_map>

#include "scene/octree.h"
#include "scene/scene.h"
#include "scene/transform.h"

namespace infra {

/// Cube of an octree or mesh file, and where the instance puts it.
struct InstanceBox {
    Cube cube;  ///< in the file's own coordinates
    Transform to_world, to_local;

    /// The 8 corners in world coordinates, numbered as Cube::octant.
    std::array<Vec3, 8> corners() const;
};

/// Reads the headers of files that `instance` and `mesh` primitives refer to, each file once.
class InstanceBoxes {
  public:
    explicit InstanceBoxes(const Scene& scene) : scene_(scene) {}

    /// throws  Error at the primitive for a missing or unusable file or a transform that is none
    const InstanceBox& at(PrimitiveId id);

  private:
    Cube cube_of_file(PrimitiveId id);

    const Scene& scene_;
    std::map<std::string, Cube, std::less<>> cubes_;
    std::unordered_map<PrimitiveId, InstanceBox> boxes_;
};

}  // namespace infra
