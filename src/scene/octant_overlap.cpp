#include "scene/octant_overlap.h"

#include <cmath>
#include <optional>

#include "scene/clip_box.h"
#include "scene/surface_geometry.h"

namespace infra {
namespace {

constexpr unsigned octants_of[3][2] = {
    {0x55, 0xaa}, {0x33, 0xcc}, {0x0f, 0xf0}};  // by axis, lower and upper half

bool near(double a, double b) { return std::abs(a - b) <= tiny_length; }

}  // namespace

/// A polygon and its plane, which is found when it is first needed.
class OctantOverlap::Polygon {
  public:
    explicit Polygon(std::span<const Vec3> corners) : corners_(corners) {}

    /// Where no edge of the polygon enters the octant: does its inside? Then it meets the octant's diagonal
    /// that is nearest to its normal.
    bool meets_inside(const ClipBox& octant) {
        if (!plane_) plane_ = corner_plane(corners_);
        const Vec3& normal = plane_->normal;
        Vec3 back, front;
        for (int i = 0; i < 3; ++i) {
            back[i] = normal[i] > 0 ? octant.low[i] : octant.high[i];
            front[i] = normal[i] > 0 ? octant.high[i] : octant.low[i];
        }
        const double below = dot(back, normal) - plane_->offset, above = dot(front, normal) - plane_->offset;
        if (below > tiny_length || above < -tiny_length) return false;
        return holds((back * above - front * below) / (above - below));
    }

  private:
    /// Whether a point of the plane lies inside or within tiny_length of an edge: edges crossed by the ray
    /// from it along x are odd in number.
    bool holds(const Vec3& p) const {
        const Vec3& normal = plane_->normal;
        int dropped = std::abs(normal.y) > std::abs(normal.x) ? 1 : 0;
        if (std::abs(normal.z) > std::abs(normal[dropped])) dropped = 2;
        const int x = (dropped + 1) % 3, y = (dropped + 2) % 3;
        bool inside = false;
        const Vec3* last = &corners_.back();
        for (const Vec3& b : corners_) {
            const Vec3& a = *std::exchange(last, &b);
            const bool a_right = a[x] > p[x], b_right = b[x] > p[x];
            const bool a_above = a[y] > p[y], b_above = b[y] > p[y];
            if (a_right != b_right && near(a[y], p[y]) && near(b[y], p[y])) return true;
            if (a_above == b_above) continue;
            if (a_right && b_right) {
                inside = !inside;
            } else if (a_right || b_right) {
                const double one = (a[y] - p[y]) * (b[x] - p[x]), other = (a[x] - p[x]) * (b[y] - p[y]);
                if (near(one, other)) return true;
                if ((b[y] > a[y]) != (one > other)) inside = !inside;
            } else if (near(a[x], p[x]) && near(b[x], p[x])) {
                return true;
            }
        }
        return inside;
    }

    std::span<const Vec3> corners_;
    std::optional<CornerPlane> plane_;
};

OctantOverlap::OctantOverlap(const Cube& cell) {
    const double half = 0.5 * cell.size;
    for (int axis = 0; axis < 3; ++axis) {
        for (int upper = 0; upper < 2; ++upper) {
            Slab& slab = slabs_[axis][upper];
            slab.low = cell.origin[axis] + (upper ? half : 0.0) - tiny_length;
            slab.high = slab.low + half + 2 * tiny_length;
            slab.outside_low = slab.low - tiny_length;
            slab.outside_high = slab.high + tiny_length;
        }
    }
}

/// The sides of all corners of all slabs are found once and serve every octant.
unsigned OctantOverlap::few_corners(std::span<const Vec3> corners) const {
    const unsigned all_corners = ~0u >> (32 - corners.size());
    Sides sides[3][2];
    unsigned apart = 0;  // octants that have all corners on one side
    for (int axis = 0; axis < 3; ++axis) {
        for (int upper = 0; upper < 2; ++upper) {
            const Slab& slab = slabs_[axis][upper];
            unsigned below = 0, above = 0;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                below |= unsigned(corners[i][axis] < slab.outside_low) << i;
                above |= unsigned(corners[i][axis] > slab.outside_high) << i;
            }
            sides[axis][upper] = {below, above};
            if (below == all_corners || above == all_corners) apart |= octants_of[axis][upper];
        }
    }
    Polygon polygon(corners);
    unsigned touched = 0;
    for (unsigned branch = 0; branch < 8; ++branch) {
        if (apart >> branch & 1) continue;
        const unsigned half[3] = {branch & 1, branch >> 1 & 1, branch >> 2 & 1};
        ClipBox octant;
        const Sides* side[3];
        unsigned outside = 0;
        for (int axis = 0; axis < 3; ++axis) {
            octant.low[axis] = slabs_[axis][half[axis]].low;
            octant.high[axis] = slabs_[axis][half[axis]].high;
            side[axis] = &sides[axis][half[axis]];
            outside |= side[axis]->below | side[axis]->above;
        }
        bool touches = outside != all_corners;
        for (std::size_t i = 0; i < corners.size() && !touches; ++i) {
            const std::size_t next = i + 1 < corners.size() ? i + 1 : 0;
            const unsigned edge = 1u << i | 1u << next;
            bool beyond = false;
            for (const Sides* s : side) beyond |= (s->below & edge) == edge || (s->above & edge) == edge;
            touches = !beyond && octant.holds_part_of(corners[i], corners[next]);
        }
        if (touches || polygon.meets_inside(octant)) touched |= 1u << branch;
    }
    return touched;
}

unsigned OctantOverlap::many_corners(std::span<const Vec3> corners) const {
    Polygon polygon(corners);
    unsigned touched = 0;
    for (unsigned branch = 0; branch < 8; ++branch) {
        const unsigned half[3] = {branch & 1, branch >> 1 & 1, branch >> 2 & 1};
        ClipBox octant;
        for (int axis = 0; axis < 3; ++axis) {
            octant.low[axis] = slabs_[axis][half[axis]].low;
            octant.high[axis] = slabs_[axis][half[axis]].high;
        }
        unsigned shared = ~0u;  // sides that all corners have in common
        bool touches = false;
        for (std::size_t i = 0; i < corners.size() && !touches; ++i) {
            const unsigned code = octant.outcode(corners[i]);
            shared &= code;
            touches = code == 0;
        }
        if (!touches && shared != 0) continue;
        for (std::size_t i = 0; i < corners.size() && !touches; ++i)
            touches = octant.holds_part_of(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
        if (touches || polygon.meets_inside(octant)) touched |= 1u << branch;
    }
    return touched;
}

unsigned OctantOverlap::operator()(std::span<const Vec3> corners) const {
    return corners.size() <= 32 ? few_corners(corners) : many_corners(corners);
}

}  // namespace infra
