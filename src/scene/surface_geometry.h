// What oconv must know of a surface: is it usable, how far does it extend, does it touch a cell.
#pragma once

#include <string_view>
#include <vector>

#include "scene/instance_box.h"
#include "scene/octree.h"
#include "scene/scene.h"

namespace infra {

/// Distances below this are none, scene units (RADIANCE's).
inline constexpr double tiny_length = 1e-6;

/// Axis-parallel box; empty when made.
struct Box {
    Vec3 low{1e30}, high{-1e30};

    bool empty() const { return low.x > high.x; }
    void add(const Vec3& p);
    void add(const Box& other);
};

/// A cone, cylinder or ring as a line turned about an axis: from radius r0 at height 0 to r1 at height
/// `height`.
struct TurnedLine {
    Vec3 base;
    Vec3 axis;  ///< unit length
    double height = 0;
    double r0 = 0, r1 = 0;  ///< >= 0

    /// Distance of a point from the surface.
    double distance(const Vec3& p) const;
};

/// The line that turns into this cone, cup, cylinder, tube or ring; radii made positive.
/// Only for a surface that check_surface() calls usable.
TurnedLine turned_line(const Scene& scene, PrimitiveId id);

/// Whether a surface has any area, and what to warn of.
struct SurfaceCheck {
    bool usable = true;
    std::string_view remark;  ///< "" if all is well
};

/// throws  Error for a wrong number of arguments
SurfaceCheck check_surface(const Scene& scene, PrimitiveId id);

/// Box of a surface or volume; empty for a distant source.
Box surface_box(const Scene& scene, PrimitiveId id, InstanceBoxes& instances);

}  // namespace infra
