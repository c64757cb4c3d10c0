// All shapes of a scene and the hierarchy over them: what a ray hits, and whether anything lies in its way.
// Immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rt/geometry/bvh.h"
#include "rt/shapes/cone.h"
#include "rt/shapes/polygon.h"
#include "rt/shapes/ring.h"
#include "rt/shapes/sphere.h"
#include "scene/scene.h"

namespace infra {

/// Kind (three high bits) and index of a shape among those of its kind.
using ShapeRef = std::uint32_t;

class Geometry {
  public:
    enum Kind : std::uint32_t {
        triangle,
        polygon,
        sphere,
        cone,
        ring
    };  // triangle is 0: sort_triangles relies on it

    /// What stands between two points.
    enum class View { clear, blocked, filtered };

    /// table: decides between surfaces in the same place; must outlive the geometry.
    explicit Geometry(const SurfaceTable& table) : table_(table) {}

    /// Makes room for this many surfaces, of which so many are triangles.
    void reserve(std::size_t surfaces, std::size_t triangles);
    /// Adds a primitive's shape as surface number `surface`. False for one that no ray can meet (no area, no
    /// radius).
    ///   throws  Error if the primitive's type is no shape known here
    bool add(const Scene& scene, PrimitiveId id, int surface);
    /// Builds the hierarchy; to be called once, after the last add().
    void build();

    /// Nearest hit beyond `same_place` and nearer than state.distance; `leaving` is a shape not to be tested.
    void intersect(const Vec3& origin, const Vec3& direction, ShapeRef leaving, HitState& state) const;
    /// The same for one surface alone (a light source that is aimed at). False if it is missed.
    bool intersect_one(ShapeRef shape, const Vec3& origin, const Vec3& direction, HitState& state) const;
    /// blocked as soon as anything opaque is found nearer than `distance`; filtered if only other things are.
    View view(const Vec3& origin, const Vec3& direction, double distance, ShapeRef leaving) const;

    /// Unit normal of a shape at a point on it.
    Vec3 normal(ShapeRef shape, const Vec3& point) const;
    static bool is_flat(ShapeRef shape) {
        return kind(shape) == triangle || kind(shape) == polygon || kind(shape) == ring;
    }

    /// Shape of a surface, no_shape if it has none.
    static constexpr ShapeRef no_shape = ~0u;
    ShapeRef shape_of(int surface) const {
        return static_cast<std::size_t>(surface) < shape_of_.size()
                   ? shape_of_[static_cast<std::size_t>(surface)]
                   : no_shape;
    }

  private:
    static Kind kind(ShapeRef shape) { return static_cast<Kind>(shape >> 29); }
    static std::size_t index(ShapeRef shape) { return shape & 0x1fffffffu; }
    void test(ShapeRef shape, const Vec3& origin, const Vec3& direction, HitState& state) const;
    void note(Kind kind, std::size_t index, int surface, const Bounds& box);
    void sort_triangles();
    bool add_polygon(std::span<const double> vertices, int surface);
    bool add_cone(PrimitiveType type, std::span<const double> numbers, int surface);

    const SurfaceTable& table_;
    std::vector<Triangle> triangles_;
    std::vector<Polygon> polygons_;
    std::vector<std::unique_ptr<double[]>> corners_;
    std::vector<Bvh::Item> items_;  // for building only
    std::vector<Sphere> spheres_;
    std::vector<Cone> cones_;
    std::vector<Ring> rings_;
    std::vector<ShapeRef> shape_of_;
    Bvh bvh_;
};

}  // namespace infra
