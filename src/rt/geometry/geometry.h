// All shapes of a scene and the hierarchy over them: what a ray hits, and whether anything lies in its way.
// Immutable once built.
//
// An instance is a shape whose content is another Geometry, an octree's or a mesh's, kept once however often
// it is placed. A ray is carried into the content's coordinates and back. So a shape is found by its ShapeRef
// in the innermost content, and a number for the way there: all instances within instances are counted
// through, from 1, those of one content standing together. Number 0 is the scene itself.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rt/geometry/bvh.h"
#include "rt/geometry/placement.h"
#include "rt/shapes/cone.h"
#include "rt/shapes/facets.h"
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
        ring,
        facet,  // of a mesh
        instance
    };

    /// What stands between two points, from good to bad.
    enum class View { clear, filtered, blocked };

    /// Whose shapes: only those of the scene itself can be found by surface (shape_of).
    enum class Role { scene, content };

    /// table: decides between surfaces in the same place; must outlive the geometry.
    explicit Geometry(const SurfaceTable& table, Role role = Role::scene) : table_(table), role_(role) {}

    /// Makes room for this many surfaces, of which so many are triangles.
    void reserve(std::size_t surfaces, std::size_t triangles);
    /// Adds a primitive's shape as surface number `surface`. False for one that no ray can meet (no area, no
    /// radius). All primitives are of one scene, which keeps its arguments until build().
    ///   throws  Error if the primitive's type is no shape known here
    bool add(const Scene& scene, PrimitiveId id, int surface);
    /// Makes it a mesh. The surface of facets that have no material becomes that of each instance.
    void set_facets(Facets facets, int surface_without_material);
    /// Places a content, which is built and stays alive, as surface number `surface`.
    ///   covers  that surface hides the content's own surfaces and their modifiers
    void add_instance(const Geometry& content, const Placement& placement, int surface, bool covers);
    /// Builds the hierarchy; to be called once, after the last add(). Only then rays may be traced.
    void build();

    /// Nearest hit beyond `same_place` and nearer than state.distance; `leaving` is a shape not to be tested.
    void intersect(const Vec3& origin, const Vec3& direction, const PlacedShape& leaving,
                   HitState& state) const;
    /// The same for one surface alone (a light source that is aimed at). False if it is missed.
    bool intersect_one(ShapeRef shape, const Vec3& origin, const Vec3& direction, HitState& state) const;
    /// blocked as soon as anything opaque is found nearer than `distance`; filtered if only other things are.
    View view(const Vec3& origin, const Vec3& direction, double distance, const PlacedShape& leaving) const {
        return view_before(origin, direction, distance - same_place, leaving);
    }

    /// The walk of rays, for tests; the best for the processor unless told.
    void use(BvhKernel kernel) { bvh_.use(kernel); }

    /// Box around all shapes; empty if there are none.
    const Bounds& bounds() const { return bvh_.bounds(); }

    /// Unit normal of a shape, which is no instance, at a point on it.
    Vec3 normal(ShapeRef shape, const Vec3& point) const;
    /// Normal, shape, instance and a mesh's coordinates at a hit whose point is known.
    void describe(const HitState& state, Interaction& at) const {
        if (kind(state.shape) == instance) [[unlikely]]
            return describe_inner(state.inner, at);
        at.normal = normal(state.shape, at.point);
        at.flat_shape = is_flat(state.shape) ? state.shape : no_shape;
    }

    /// Where the coordinates of the modifiers stand that are met in instance `number`: within the instances
    /// around it, up to the first that hides its content behind modifiers of its own.
    ///   returns  false if that is the scene itself
    bool modifier_placement(std::uint64_t number, Placement& placement) const;
    /// Whether instance `number` or one around it hides its content's own surfaces.
    bool is_covered(std::uint64_t number) const;

    /// Shape of a surface, no_shape if it has none.
    static constexpr ShapeRef no_shape = ~0u;
    ShapeRef shape_of(int surface) const {
        return static_cast<std::size_t>(surface) < shape_of_.size()
                   ? shape_of_[static_cast<std::size_t>(surface)]
                   : no_shape;
    }

  private:
    struct Instance {
        Placement placement;
        const Geometry* content;
        int surface;
        bool covers;
        std::uint64_t first_number;  ///< its own; those of the instances in it follow
    };
    /// The innermost content that a number leads to.
    struct Located {
        const Geometry* content;
        Placement placement;
    };

    static Kind kind(ShapeRef shape) { return static_cast<Kind>(shape >> 29); }
    static std::size_t index(ShapeRef shape) { return shape & 0x1fffffffu; }
    static ShapeRef shape_ref(Kind kind, std::size_t index) {
        return static_cast<ShapeRef>(kind) << 29 | static_cast<ShapeRef>(index);
    }
    static bool is_flat(ShapeRef shape) {
        const Kind k = kind(shape);
        return k == triangle || k == polygon || k == ring || k == facet;
    }
    void test(ShapeRef shape, const Vec3& origin, const Vec3& direction, const PlacedShape& leaving,
              HitState& state) const;
    View view_past(int surface) const {
        return table_.finish(surface).blocks_light() ? View::blocked : View::filtered;
    }
    View view_before(const Vec3& origin, const Vec3& direction, double limit,
                     const PlacedShape& leaving) const;
    void note(Kind kind, std::size_t index, int surface, const Bounds& box);
    /// The hierarchy's triangles count from 0; its other items are shapes of other kinds, whose numbers are
    /// higher.
    ShapeRef shape_of_item(std::uint32_t item) const {
        return item < (1u << 29) ? first_triangle_ + item : item;
    }

    // instances.cpp
    static PlacedShape leaving_inside(const Instance& it, const PlacedShape& leaving);
    void test_instance(ShapeRef shape, const Vec3& origin, const Vec3& direction, const PlacedShape& leaving,
                       HitState& state) const;
    View view_instance(ShapeRef shape, const Vec3& origin, const Vec3& direction, double limit,
                       const PlacedShape& leaving) const;
    void describe_inner(const PlacedShape& inner, Interaction& at) const;
    const Instance& instance_of(std::uint64_t number) const;
    Located locate(std::uint64_t number) const;
    class TrianglePlacer;
    class FacetPlacer;
    bool add_polygon(const Scene& scene, PrimitiveId id, int surface);
    bool add_triangle(const Scene& scene, PrimitiveId id, int surface);
    void set_shape_of(int surface, ShapeRef shape);
    bool add_cone(PrimitiveType type, std::span<const double> numbers, int surface);

    const SurfaceTable& table_;
    Role role_;
    LargeVector<Triangle> triangles_;
    std::vector<Polygon> polygons_;
    std::vector<std::unique_ptr<double[]>> corners_;
    // For building only, as the next two. Numbered by surface, with the primitive as their note; facets by
    // their place.
    LargeVector<Bvh::Item> triangle_items_;
    std::vector<Bvh::Item> other_items_;
    const Scene* scene_ = nullptr;
    ShapeRef first_triangle_ = 0;  // what the hierarchy calls 0: a triangle or a facet
    std::vector<Sphere> spheres_;
    std::vector<Cone> cones_;
    std::vector<Ring> rings_;
    Facets facets_;
    int bare_surface_ = -1;  // of facets without a material
    std::vector<Instance> instances_;
    std::uint64_t placements_ = 0;  // of all instances, and of those in them
    std::vector<ShapeRef> shape_of_;
    Bvh bvh_;
};

}  // namespace infra
