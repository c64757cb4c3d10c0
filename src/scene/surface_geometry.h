// What oconv must know of a surface: is it usable, how far does it extend, does it touch a cell.
#pragma once

#include <string_view>
#include <vector>

#include "scene/clip_box.h"
#include "scene/instance_box.h"
#include "scene/octree.h"
#include "scene/scene.h"

namespace infra {

/// Axis-parallel box; empty when made.
struct Box {
    Vec3 low{1e30}, high{-1e30};

    bool empty() const { return low.x > high.x; }
    void add(const Vec3& p);
    void add(const Box& other);
};

/// Corners of a polygon; a last one that repeats the first is left out.
void polygon_corners(std::span<const double> reals, std::vector<Vec3>& corners);

/// The plane of points p with dot(normal, p) = offset that lies closest to a polygon.
struct CornerPlane {
    Vec3 normal;  ///< towards the front, unit length; zero if the polygon has no area
    double offset = 0;
};
CornerPlane corner_plane(std::span<const Vec3> corners);

/// A cone, cylinder or ring as a line turned about an axis: from radius r0 around p0 to r1 >= r0 around p1.
struct TurnedLine {
    Vec3 p0, p1;  ///< one point for a ring
    Vec3 axis;    ///< unit length, from p0 to p1
    double r0 = 0, r1 = 0;

    /// The line where it is closest to a point: its end at p0 and that at p1.
    ///   returns  false for a point of the axis, from which all are as far
    bool line_towards(const Vec3& point, Vec3& end0, Vec3& end1) const;
};

/// The line that turns into this cone, cup, cylinder, tube or ring; radii made positive.
/// Only for a surface that check_surface() calls usable.
TurnedLine turned_line(const Scene& scene, PrimitiveId id);

/// A surface as RADIANCE's oconv stores it: what has a negative radius is turned inside out, a radius that is
/// none becomes zero, a cone of equal radii a cylinder.
struct StoredSurface {
    PrimitiveType type;
    std::span<const double> reals;  ///< of the scene or in `changed`
    double changed[8];
};
void get_stored_surface(const Scene& scene, PrimitiveId id, StoredSurface& stored);

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
