// The instances of a Geometry: rays carried into their contents, and the numbers that lead there.
#include <algorithm>
#include <array>

#include "common/error.h"
#include "rt/geometry/geometry.h"

namespace infra {
namespace {

/// Numbers stay below this.
constexpr std::uint64_t most_placements = std::uint64_t{1} << 62;

}  // namespace

void Geometry::set_facets(Facets facets, int surface_without_material) {
    facets_ = std::move(facets);
    bare_surface_ = surface_without_material;
    triangle_items_.reserve(facets_.all().size() + 1);
    for (std::size_t i = 0; i < facets_.all().size(); ++i) {
        Bounds box;
        for (const Vec3& corner : facets_.corners(facets_.all()[i])) box.extend(corner);
        triangle_items_.emplace_back(box, static_cast<std::uint32_t>(i));
    }
}

void Geometry::add_instance(const Geometry& content, const Placement& placement, int surface, bool covers) {
    const Bounds& inner = content.bounds();
    if (inner.empty()) return;
    if (placements_ + content.placements_ >= most_placements)
        throw Error("too many instances within instances");
    Bounds box;
    for (int corner = 0; corner < 8; ++corner)
        box.extend(placement.point_outside({corner & 1 ? inner.hi.x : inner.lo.x,
                                            corner & 2 ? inner.hi.y : inner.lo.y,
                                            corner & 4 ? inner.hi.z : inner.lo.z}));
    instances_.push_back({placement, &content, surface, covers, placements_ + 1});
    placements_ += 1 + content.placements_;
    other_items_.emplace_back(box, shape_ref(instance, instances_.size() - 1));
}

// The shape that a ray leaves as the content of an instance knows it, if it lies in there.
PlacedShape Geometry::leaving_inside(const Instance& it, const PlacedShape& leaving) {
    const std::uint64_t inner = leaving.placement - it.first_number;
    if (leaving.placement < it.first_number || inner > it.content->placements_) return {};
    return {leaving.shape, inner};
}

void Geometry::test_instance(ShapeRef shape, const Vec3& origin, const Vec3& direction,
                             const PlacedShape& leaving, HitState& state) const {
    const Instance& it = instances_[index(shape)];
    const double scale = it.placement.scale();
    HitState found;
    found.distance = (state.distance + same_place) / scale;
    it.content->intersect(it.placement.point_inside(origin), it.placement.direction_inside(direction),
                          leaving_inside(it, leaving), found);
    if (found.surface < 0) return;
    const bool replaced = it.covers || found.surface == it.content->bare_surface_;
    if (!take_hit(state, table_, found.distance * scale, found.front, replaced ? it.surface : found.surface,
                  shape))
        return;
    const bool deeper = kind(found.shape) == instance;
    state.inner = {deeper ? found.inner.shape : found.shape,
                   it.first_number + (deeper ? found.inner.placement : 0)};
}

Geometry::View Geometry::view_instance(ShapeRef shape, const Vec3& origin, const Vec3& direction,
                                       double limit, const PlacedShape& leaving) const {
    const Instance& it = instances_[index(shape)];
    const View seen =
        it.content->view_before(it.placement.point_inside(origin), it.placement.direction_inside(direction),
                                limit / it.placement.scale(), leaving_inside(it, leaving));
    return seen == View::clear || !it.covers ? seen : view_past(it.surface);
}

const Geometry::Instance& Geometry::instance_of(std::uint64_t number) const {
    const auto next = std::upper_bound(
        instances_.begin(), instances_.end(), number,
        [](std::uint64_t wanted, const Instance& candidate) { return wanted < candidate.first_number; });
    return *(next - 1);
}

Geometry::Located Geometry::locate(std::uint64_t number) const {
    Located place{this, {}};
    while (number > 0) {
        const Instance& it = place.content->instance_of(number);
        place.placement = place.placement.around(it.placement);
        place.content = it.content;
        number -= it.first_number;
    }
    return place;
}

bool Geometry::modifier_placement(std::uint64_t number, Placement& placement) const {
    placement = {};
    bool placed = false;
    for (const Geometry* content = this; number > 0; placed = true) {
        const Instance& it = content->instance_of(number);
        if (it.covers) break;
        placement = placement.around(it.placement);
        content = it.content;
        number -= it.first_number;
    }
    return placed;
}

bool Geometry::is_covered(std::uint64_t number) const {
    for (const Geometry* content = this; number > 0;) {
        const Instance& it = content->instance_of(number);
        if (it.covers) return true;
        content = it.content;
        number -= it.first_number;
    }
    return false;
}

// The textures add to a mesh's interpolated normal as to one another.
void Geometry::describe_inner(const PlacedShape& inner, Interaction& at) const {
    const Located place = locate(inner.placement);
    const Vec3 point = place.placement.point_inside(at.point);
    at.placement = inner.placement;
    at.flat_shape = is_flat(inner.shape) ? inner.shape : no_shape;
    at.normal = place.placement.direction_outside(place.content->normal(inner.shape, point));
    if (kind(inner.shape) != facet) return;
    const Facets::Detail detail = place.content->facets_.detail(index(inner.shape), point);
    at.perturbation = place.placement.direction_outside(detail.normal) - at.normal;
    at.local_uv[0] = detail.uv[0];
    at.local_uv[1] = detail.uv[1];
}

}  // namespace infra
