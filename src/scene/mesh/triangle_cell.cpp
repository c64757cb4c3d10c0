#include "scene/mesh/triangle_cell.h"

#include <cmath>

#include "scene/surface_geometry.h"

namespace infra {
namespace {

constexpr unsigned all_corners = 7;
constexpr unsigned octants_of[3][2] = {
    {0x55, 0xaa}, {0x33, 0xcc}, {0x0f, 0xf0}};  // by axis, lower and upper half

bool near(double a, double b) { return std::abs(a - b) <= tiny_length; }

}  // namespace

/// One octant as the slabs that it is the intersection of, and where the triangle's corners are.
struct OctantOverlap::Octant {
    const Slab* axis[3];
    const Sides* sides[3];

    /// Whether all these corners lie on one side of it.
    bool apart_from(unsigned corners) const {
        for (const Sides* s : sides)
            if ((s->below & corners) == corners || (s->above & corners) == corners) return true;
        return false;
    }

    /// Which side of which slab a point lies on, 2 bits an axis; 0 inside.
    unsigned outcode(const Vec3& p) const {
        unsigned code = 0;
        for (int i = 0; i < 3; ++i) {
            if (p[i] < axis[i]->outside_low)
                code |= 1u << 2 * i;
            else if (p[i] > axis[i]->outside_high)
                code |= 2u << 2 * i;
        }
        return code;
    }

    bool holds_part_of(Vec3 a, Vec3 b) const;
    bool meets_inside_of(const std::array<Vec3, 3>& corners) const;
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

/// Does any part of the way from a to b lie in the octant? Cuts off what lies beyond one face after another.
/// source: Cohen and Sutherland's algorithm, Newman & Sproull, "Principles of Interactive Computer Graphics"
/// (1979).
bool OctantOverlap::Octant::holds_part_of(Vec3 a, Vec3 b) const {
    unsigned code_a = outcode(a), code_b = outcode(b);
    for (int cuts = 0; code_a | code_b; ++cuts) {
        constexpr int most_cuts = 6;
        if (code_a & code_b || cuts == most_cuts) return false;
        if (code_a == 0) {
            std::swap(a, b);
            std::swap(code_a, code_b);
        }
        int i = 0;
        while ((code_a >> 2 * i & 3) == 0) ++i;
        const double plane = code_a >> 2 * i & 1 ? axis[i]->low : axis[i]->high;
        const double part = (plane - a[i]) / (b[i] - a[i]);
        const Vec3 way = b - a;
        for (int j = 0; j < 3; ++j) a[j] = j == i ? plane : a[j] + way[j] * part;
        code_a = outcode(a);
    }
    return true;
}

/// Where no edge of the triangle enters the octant: does its inside? Then it meets the octant's diagonal that
/// is nearest to its normal.
bool OctantOverlap::Octant::meets_inside_of(const std::array<Vec3, 3>& corners) const {
    Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    normal /= length(normal);
    const double offset = (dot(normal, corners[0]) + dot(normal, corners[1]) + dot(normal, corners[2])) / 3.0;
    Vec3 back, front;
    for (int i = 0; i < 3; ++i) {
        back[i] = normal[i] > 0 ? axis[i]->low : axis[i]->high;
        front[i] = normal[i] > 0 ? axis[i]->high : axis[i]->low;
    }
    const double below = dot(back, normal) - offset, above = dot(front, normal) - offset;
    if (below > tiny_length || above < -tiny_length) return false;
    const Vec3 p = (back * above - front * below) / (above - below);

    int dropped = std::abs(normal.y) > std::abs(normal.x) ? 1 : 0;
    if (std::abs(normal.z) > std::abs(normal[dropped])) dropped = 2;
    const int x = (dropped + 1) % 3, y = (dropped + 2) % 3;
    bool inside = false;  // edges crossed by the ray from p along x: odd
    for (int i = 0; i < 3; ++i) {
        const Vec3 &a = corners[(i + 2) % 3], &b = corners[i];
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

/// For a triangle with no corner inside and not all of them on one side.
bool OctantOverlap::crosses(const std::array<Vec3, 3>& corners, const Octant& octant) {
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        if (octant.apart_from(1u << i | 1u << next)) continue;
        if (octant.holds_part_of(corners[i], corners[next])) return true;
    }
    return octant.meets_inside_of(corners);
}

unsigned OctantOverlap::operator()(const std::array<Vec3, 3>& corners) const {
    Sides sides[3][2];
    unsigned apart = 0;  // octants that have all corners on one side
    for (int axis = 0; axis < 3; ++axis) {
        for (int upper = 0; upper < 2; ++upper) {
            const Slab& slab = slabs_[axis][upper];
            unsigned below = 0, above = 0;
            for (int i = 0; i < 3; ++i) {
                below |= unsigned(corners[i][axis] < slab.outside_low) << i;
                above |= unsigned(corners[i][axis] > slab.outside_high) << i;
            }
            sides[axis][upper] = {below, above};
            if (below == all_corners || above == all_corners) apart |= octants_of[axis][upper];
        }
    }
    unsigned touched = 0;
    for (unsigned branch = 0; branch < 8; ++branch) {
        if (apart >> branch & 1) continue;
        const unsigned half[3] = {branch & 1, branch >> 1 & 1, branch >> 2 & 1};
        Octant octant;
        unsigned outside = 0;
        for (int axis = 0; axis < 3; ++axis) {
            octant.axis[axis] = &slabs_[axis][half[axis]];
            octant.sides[axis] = &sides[axis][half[axis]];
            outside |= octant.sides[axis]->below | octant.sides[axis]->above;
        }
        if (outside != all_corners || crosses(corners, octant)) touched |= 1u << branch;
    }
    return touched;
}

}  // namespace infra
