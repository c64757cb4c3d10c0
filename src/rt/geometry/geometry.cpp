#include "rt/geometry/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rt/geometry/bvh_walk.h"

namespace infra {
namespace {

Vec3 vec(std::span<const double> numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

std::array<Vec3, 3> triangle_corners(std::span<const double> numbers) {
    return {vec(numbers, 0), vec(numbers, 3), vec(numbers, 6)};
}

// Bounds of a disk of this radius.
Bounds disk_box(const Vec3& center, const Vec3& axis, double radius) {
    Bounds box;
    const Vec3 reach{radius * std::sqrt(std::max(0.0, 1 - axis.x * axis.x)),
                     radius * std::sqrt(std::max(0.0, 1 - axis.y * axis.y)),
                     radius * std::sqrt(std::max(0.0, 1 - axis.z * axis.z))};
    box.extend(center - reach);
    box.extend(center + reach);
    return box;
}

}  // namespace

void Geometry::reserve(std::size_t surfaces, std::size_t triangles) {
    shape_of_.reserve(surfaces);
    triangle_items_.reserve(triangles + 1);
}

void Geometry::note(Kind kind, std::size_t index, int surface, const Bounds& box) {
    const ShapeRef shape = shape_ref(kind, index);
    other_items_.emplace_back(box, shape);
    set_shape_of(surface, shape);
}

void Geometry::set_shape_of(int surface, ShapeRef shape) {
    if (role_ == Role::content) return;
    if (shape_of_.size() <= static_cast<std::size_t>(surface))
        shape_of_.resize(static_cast<std::size_t>(surface) + 1, no_shape);
    shape_of_[static_cast<std::size_t>(surface)] = shape;
}

bool Geometry::add(const Scene& scene, PrimitiveId id, int surface) {
    const std::span<const double> numbers = scene.reals(id);
    switch (const PrimitiveType type = scene.type(id)) {
        case PrimitiveType::polygon:
            return add_polygon(scene, id, surface);
        case PrimitiveType::sphere:
        case PrimitiveType::bubble: {
            const double radius = std::fabs(numbers[3]);
            if (radius <= same_place) return false;
            const bool inward = (type == PrimitiveType::bubble) != (numbers[3] < 0);
            const Vec3 center = vec(numbers, 0);
            spheres_.push_back({center, radius, surface, inward});
            note(sphere, spheres_.size() - 1, surface, {center - Vec3(radius), center + Vec3(radius)});
            return true;
        }
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
            return add_cone(type, numbers, surface);
        case PrimitiveType::ring: {
            const double inner = std::min(numbers[6], numbers[7]), outer = std::max(numbers[6], numbers[7]);
            const Vec3 axis = vec(numbers, 3);
            const double size = length(axis);
            if (!(size > 0) || outer <= same_place) return false;
            rings_.push_back({vec(numbers, 0), axis / size, std::max(inner, 0.0), outer, surface});
            note(ring, rings_.size() - 1, surface, disk_box(vec(numbers, 0), axis / size, outer));
            return true;
        }
        default:
            throw scene.error(id,
                              std::string("type \"") + std::string(name(type)) + "\" is not supported yet");
    }
}

bool Geometry::add_polygon(const Scene& scene, PrimitiveId id, int surface) {
    const std::span<const double> vertices = distinct_vertices(scene.reals(id));
    const std::size_t count = vertices.size() / 3;
    if (count == 3) return add_triangle(scene, id, surface);
    const PolygonPlane plane = polygon_plane(vertices);
    if (plane.area == 0) return false;
    Bounds box;
    for (std::size_t i = 0; i < count; ++i) box.extend(vec(vertices, 3 * i));
    int axis = std::fabs(plane.normal.y) > std::fabs(plane.normal.x) ? 1 : 0;
    if (std::fabs(plane.normal.z) > std::fabs(plane.normal[axis])) axis = 2;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    auto corners = std::make_unique<double[]>(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        corners[2 * i] = vertices[3 * i + static_cast<std::size_t>(x)];
        corners[2 * i + 1] = vertices[3 * i + static_cast<std::size_t>(y)];
        // A polygon that is not flat is met in its mean plane, which may stick out of the vertices' box.
        const Vec3 vertex = vec(vertices, 3 * i);
        box.extend(vertex + plane.normal * (plane.offset - dot(plane.normal, vertex)));
    }
    polygons_.push_back({plane.normal, plane.offset, corners.get(), static_cast<int>(count), surface, x, y});
    corners_.push_back(std::move(corners));
    note(polygon, polygons_.size() - 1, surface, box);
    return true;
}

bool Geometry::add_triangle(const Scene& scene, PrimitiveId id, int surface) {
    scene_ = &scene;
    const std::array<Vec3, 3> corners = triangle_corners(scene.reals(id));
    const TriangleLimits limits(corners);
    if (limits.doubled_area == 0) return false;
    const Vec3 beyond(limits.uncertainty());
    triangle_items_.emplace_back(Bounds{limits.lo - beyond, limits.hi + beyond},
                                 static_cast<std::uint32_t>(surface), static_cast<std::uint32_t>(id));
    return true;
}

bool Geometry::add_cone(PrimitiveType type, std::span<const double> numbers, int surface) {
    const Vec3 p0 = vec(numbers, 0), p1 = vec(numbers, 3);
    const double size = length(p1 - p0);
    double r0 = numbers[6], r1 = numbers.size() > 7 ? numbers[7] : numbers[6];
    bool inward = type == PrimitiveType::cup || type == PrimitiveType::tube;
    if (r0 < -same_place || r1 < -same_place) inward = !inward;
    r0 = std::fabs(r0);
    r1 = std::fabs(r1);
    if (!(size > 0) || std::max(r0, r1) <= same_place) return false;
    if (std::fabs(r1 - r0) <= same_place) r1 = r0;
    const Vec3 axis = (p1 - p0) / size;
    cones_.push_back({p0, axis, size, r0, (r1 - r0) / size, surface, inward});
    Bounds box = disk_box(p0, axis, r0);
    box.extend(disk_box(p1, axis, r1));
    note(cone, cones_.size() - 1, surface, box);
    return true;
}

/// Makes the triangles of a scene, or puts the facets of a mesh in order.
class Geometry::TrianglePlacer : public Bvh::LeafTriangles {
  public:
    explicit TrianglePlacer(Geometry& geometry) : geometry_(geometry) {
        geometry.triangles_.resize(geometry.triangle_items_.size());
    }
    void announce(std::span<const Bvh::Item> items) const override {
        for (const Bvh::Item& item : items) {
            const double* const numbers =
                geometry_.scene_->reals(static_cast<PrimitiveId>(item.note())).data();
            __builtin_prefetch(numbers);
            __builtin_prefetch(numbers + 8);
        }
    }
    double place(std::span<const Bvh::Item> items, std::size_t first, std::array<Vec3, 3>* corners) override {
        double uncertainty = 0;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const auto surface = static_cast<int>(items[i].id());
            const auto primitive = static_cast<PrimitiveId>(items[i].note());
            corners[i] = triangle_corners(geometry_.scene_->reals(primitive));
            const auto& [a, b, c] = corners[i];
            geometry_.triangles_[first + i] = Triangle(a, b, c, surface);
            geometry_.set_shape_of(surface, shape_ref(triangle, first + i));
            uncertainty = std::max(uncertainty, TriangleLimits(corners[i]).uncertainty());
        }
        return uncertainty;
    }

  private:
    Geometry& geometry_;
};

class Geometry::FacetPlacer : public Bvh::LeafTriangles {
  public:
    explicit FacetPlacer(Facets& facets) : facets_(facets), ordered_(facets.all().size()) {}
    void announce(std::span<const Bvh::Item> items) const override {
        for (const Bvh::Item& item : items) __builtin_prefetch(&facets_.all()[item.id()]);
    }
    double place(std::span<const Bvh::Item> items, std::size_t first, std::array<Vec3, 3>* corners) override {
        for (std::size_t i = 0; i < items.size(); ++i) {
            ordered_[first + i] = facets_.all()[items[i].id()];
            corners[i] = facets_.corners(ordered_[first + i]);
        }
        return 0;
    }
    LargeVector<Facets::Facet> ordered() && { return std::move(ordered_); }

  private:
    Facets& facets_;
    LargeVector<Facets::Facet> ordered_;
};

void Geometry::build() {
    const bool is_mesh = !facets_.all().empty();
    first_triangle_ = shape_ref(is_mesh ? facet : triangle, 0);
    if (is_mesh) {
        FacetPlacer placer(facets_);
        bvh_.build(std::move(triangle_items_), other_items_, placer);
        facets_.all() = std::move(placer).ordered();
    } else {
        TrianglePlacer placer(*this);
        bvh_.build(std::move(triangle_items_), other_items_, placer);
        bvh_.set_records(triangles_.data(), sizeof(Triangle));
    }
    other_items_ = {};
    scene_ = nullptr;
}

inline void Geometry::test(ShapeRef shape, const Vec3& origin, const Vec3& direction,
                           const PlacedShape& leaving, HitState& state) const {
    const std::size_t i = index(shape);
    switch (kind(shape)) {
        case triangle:
            return triangles_[i].intersect(origin, direction, table_, shape, state);
        case polygon:
            return polygons_[i].intersect(origin, direction, table_, shape, state);
        case sphere:
            return spheres_[i].intersect(origin, direction, table_, shape, state);
        case cone:
            return cones_[i].intersect(origin, direction, table_, shape, state);
        case ring:
            return rings_[i].intersect(origin, direction, table_, shape, state);
        case facet:
            return facets_.intersect(i, origin, direction, table_, shape, state);
        case instance:
            return test_instance(shape, origin, direction, leaving, state);
    }
}

void Geometry::intersect(const Vec3& origin, const Vec3& direction, const PlacedShape& leaving,
                         HitState& state) const {
    const ShapeRef own = leaving.placement ? no_shape : leaving.shape;
    bvh_.walk(
        origin, direction,
        [&](std::uint32_t item) {
            const ShapeRef shape = shape_of_item(item);
            if (shape != own) test(shape, origin, direction, leaving, state);
            return false;
        },
        [&] { return state.distance + same_place; });
}

bool Geometry::intersect_one(ShapeRef shape, const Vec3& origin, const Vec3& direction,
                             HitState& state) const {
    test(shape, origin, direction, {}, state);
    return state.surface >= 0;
}

Geometry::View Geometry::view_before(const Vec3& origin, const Vec3& direction, double limit,
                                     const PlacedShape& leaving) const {
    View found = View::clear;
    const ShapeRef own = leaving.placement ? no_shape : leaving.shape;
    bvh_.walk(
        origin, direction,
        [&](std::uint32_t item) {
            const ShapeRef shape = shape_of_item(item);
            if (shape == own) return false;
            if (kind(shape) == instance) {
                found = std::max(found, view_instance(shape, origin, direction, limit, leaving));
                return found == View::blocked;
            }
            HitState state;
            state.distance = limit;
            test(shape, origin, direction, leaving, state);
            if (state.surface < 0) return false;
            found = std::max(found, view_past(state.surface));
            return found == View::blocked;
        },
        [&] { return limit; });
    return found;
}

Vec3 Geometry::normal(ShapeRef shape, const Vec3& point) const {
    const std::size_t i = index(shape);
    switch (kind(shape)) {
        case triangle:
            return triangles_[i].normal();
        case polygon:
            return polygons_[i].normal;
        case sphere:
            return spheres_[i].normal(point);
        case cone:
            return cones_[i].normal(point);
        case ring:
            return rings_[i].unit_normal;
        case facet:
            return facets_.normal(i);
        case instance:
            break;  // has none of its own
    }
    return Vec3{0, 0, 1};
}

}  // namespace infra
