#include "scene/octant_overlap.h"

#include <emmintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/surface_geometry.h"

namespace infra {
namespace {

constexpr unsigned all_octants = 0xff;

/// What an axis adds to the sides of a point: by bits, it lies below the lower half, below the upper, above
/// the lower, above the upper.
constexpr auto sides_along = [] {
    constexpr std::uint64_t octants_of[3][2] = {{0x55, 0xaa}, {0x33, 0xcc}, {0x0f, 0xf0}};
    std::array<std::array<std::uint64_t, 16>, 3> sides{};
    for (int axis = 0; axis < 3; ++axis)
        for (int beyond = 0; beyond < 16; ++beyond)
            for (int bit = 0; bit < 4; ++bit)
                if (beyond >> bit & 1)
                    sides[axis][beyond] |= octants_of[axis][bit & 1] << 8 * (axis + (bit & 2 ? 3 : 0));
    return sides;
}();

/// The octants that any of the sides names.
unsigned any_side(std::uint64_t sides) {
    sides |= sides >> 24;
    return unsigned(sides | sides >> 8 | sides >> 16) & all_octants;
}

/// The sides of one octant, as ClipBox tells them.
unsigned outcode(std::uint64_t sides, int branch) {
    const std::uint64_t apart = sides >> branch & 0x0101010101010101;
    return unsigned(apart * 0x0102040810204080 >> 56);  // bit i is bit 8 i
}

/// Calls visit(branch) for each octant.
template <class Visit>
void for_each(unsigned octants, Visit visit) {
    for (; octants != 0; octants &= octants - 1) visit(std::countr_zero(octants));
}

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
        Slabs& slabs = slabs_[axis];
        for (int upper = 0; upper < 2; ++upper) {
            slabs.low[upper] = cell.origin[axis] + (upper ? half : 0.0) - tiny_length;
            slabs.high[upper] = slabs.low[upper] + half + 2 * tiny_length;
            slabs.outside_low[upper] = slabs.low[upper] - tiny_length;
            slabs.outside_high[upper] = slabs.high[upper] + tiny_length;
        }
    }
    for (int i = 0; i < 4; ++i) {
        const Slabs& slabs = slabs_[i / 2 + i % 2];
        Halves& halves = halves_[i / 2];
        halves.low[i % 2] = slabs.outside_low[0];
        halves.high[i % 2] = slabs.outside_high[1];
        halves.lower[i % 2] = std::min(slabs.outside_low[1], slabs.outside_high[0]);
        halves.upper[i % 2] = std::max(slabs.outside_low[1], slabs.outside_high[0]);
    }
}

/// The bit of the octant that holds all of a triangle and shares none of it; 0 if there is no such octant.
unsigned OctantOverlap::octant_around(std::span<const Vec3, 3> corners) const {
    int upper[2];
    for (int pair = 0; pair < 2; ++pair) {
        const Halves& halves = halves_[pair];
        const __m128d a = _mm_loadu_pd(&corners[0].x + pair), b = _mm_loadu_pd(&corners[1].x + pair),
                      c = _mm_loadu_pd(&corners[2].x + pair);
        const __m128d low = _mm_min_pd(_mm_min_pd(a, b), c), high = _mm_max_pd(_mm_max_pd(a, b), c);
        const __m128d in_lower = _mm_and_pd(_mm_cmplt_pd(high, _mm_load_pd(halves.lower)),
                                            _mm_cmpge_pd(low, _mm_load_pd(halves.low)));
        const __m128d in_upper = _mm_and_pd(_mm_cmpgt_pd(low, _mm_load_pd(halves.upper)),
                                            _mm_cmple_pd(high, _mm_load_pd(halves.high)));
        if (_mm_movemask_pd(_mm_or_pd(in_lower, in_upper)) != 3) return 0;
        upper[pair] = _mm_movemask_pd(in_upper);
    }
    return 1u << (upper[0] | (upper[1] & 2) << 1);
}

ClipBox OctantOverlap::octant(int branch) const {
    ClipBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = slabs_[axis].low[branch >> axis & 1];
        box.high[axis] = slabs_[axis].high[branch >> axis & 1];
    }
    return box;
}

OctantOverlap::Sides OctantOverlap::sides_of(const Vec3& p) const {
    Sides sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Slabs& slabs = slabs_[axis];
        const __m128d x = _mm_set1_pd(p[axis]);
        const __m128 below = _mm_castpd_ps(_mm_cmplt_pd(x, _mm_load_pd(slabs.outside_low)));
        const __m128 above = _mm_castpd_ps(_mm_cmpgt_pd(x, _mm_load_pd(slabs.outside_high)));
        const int beyond = _mm_movemask_ps(_mm_shuffle_ps(below, above, _MM_SHUFFLE(2, 0, 2, 0)));
        sides |= sides_along[axis][beyond];
    }
    return sides;
}

/// All octants at once, a bit each: those that hold a corner, those that an edge enters, those that the
/// inside meets, if the ones before don't tell.
template <std::size_t count>
unsigned OctantOverlap::touched(std::span<const Vec3, count> corners) const {
    Sides shared = ~Sides(0);
    unsigned touched = 0;
    for (const Vec3& corner : corners) {
        const Sides sides = sides_of(corner);
        shared &= sides;
        touched |= ~any_side(sides);
    }
    const unsigned open = all_octants & ~any_side(shared);
    touched &= open;
    if (touched == open) return touched;

    const Vec3* last = &corners.back();
    Sides last_sides = sides_of(*last);
    for (const Vec3& corner : corners) {
        const Vec3& before = *std::exchange(last, &corner);
        const Sides sides = sides_of(corner), sides_before = std::exchange(last_sides, sides);
        for_each(open & ~touched & ~any_side(sides & sides_before), [&](int branch) {
            const bool enters = octant(branch).holds_part_of(before, outcode(sides_before, branch), corner,
                                                             outcode(sides, branch));
            touched |= unsigned(enters) << branch;
        });
    }
    Polygon polygon(corners);
    for_each(open & ~touched,
             [&](int branch) { touched |= unsigned(polygon.meets_inside(octant(branch))) << branch; });
    return touched;
}

std::uint8_t OctantOverlap::operator()(std::span<const Vec3> corners) const {
    return std::uint8_t(touched(corners));
}
std::uint8_t OctantOverlap::operator()(std::span<const Vec3, 3> corners) const {
    if (const unsigned only = octant_around(corners)) return std::uint8_t(only);
    return std::uint8_t(touched(corners));
}

}  // namespace infra
