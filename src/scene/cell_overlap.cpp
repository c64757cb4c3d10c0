#include "scene/cell_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/surface_geometry.h"

namespace infra {
namespace {

Vec3 vec(std::span<const double> reals, std::size_t first) {
    return {reals[first], reals[first + 1], reals[first + 2]};
}

Vec3 absolute(const Vec3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// A triangle (relative to the centre of a cube) and the cube are apart along an axis that is the cross
/// product of an edge and a coordinate axis, if along any. source: Akenine-Möller, "Fast 3D Triangle-Box
/// Overlap Testing", J. Graphics Tools 6 (2001).
bool apart_along_edge_axes(const std::array<Vec3, 3>& corner, double half) {
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = corner[(i + 1) % 3] - corner[i];
        const Vec3& opposite = corner[(i + 2) % 3];
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const double p = edge[u] * corner[i][v] - edge[v] * corner[i][u];
            const double q = edge[u] * opposite[v] - edge[v] * opposite[u];
            const double reach = half * (std::abs(edge[u]) + std::abs(edge[v]));
            if (std::min(p, q) > reach || std::max(p, q) < -reach) return true;
        }
    }
    return false;
}

bool sphere_touches(const Vec3& center, double radius, const Cube& cell) {
    const double half = 0.5 * cell.size;
    const Vec3 offset = absolute(center - cell.center());
    double nearest2 = 0, farthest2 = 0;
    for (int i = 0; i < 3; ++i) {
        const double outside = std::max(0.0, offset[i] - half);
        nearest2 += outside * outside;
        farthest2 += (offset[i] + half) * (offset[i] + half);
    }
    return nearest2 <= std::pow(radius + tiny_length, 2) &&
           farthest2 >= std::pow(std::max(0.0, radius - tiny_length), 2);
}

/// Decided by the spheres around and inside the cell, and where these leave it open, by its octants.
bool turned_line_touches(const TurnedLine& line, const Cube& cell, double smallest, int levels) {
    const double half = 0.5 * cell.size;
    const double distance = line.distance(cell.center());
    if (distance > std::sqrt(3.0) * half + tiny_length) return false;
    if (distance <= half || levels == 0 || half < smallest) return true;
    for (int branch = 0; branch < 8; ++branch)
        if (turned_line_touches(line, cell.octant(branch), smallest, levels - 1)) return true;
    return false;
}

bool apart_along(const Vec3& axis, const std::array<Vec3, 8>& a, const std::array<Vec3, 8>& b) {
    const auto extent = [&](const std::array<Vec3, 8>& corners) {
        double low = dot(axis, corners[0]), high = low;
        for (const Vec3& p : corners) {
            low = std::min(low, dot(axis, p));
            high = std::max(high, dot(axis, p));
        }
        return std::pair(low, high);
    };
    const auto [a_low, a_high] = extent(a);
    const auto [b_low, b_high] = extent(b);
    const double margin = tiny_length * length(axis);
    return a_low > b_high + margin || b_low > a_high + margin;
}

/// Separating axes of two boxes: their edges and the cross products of those.
Overlap box_overlap(const InstanceBox& box, const Cube& cell) {
    const InstanceBox cell_box{cell, {}};
    const auto a = box.corners(), b = cell_box.corners();
    const std::array<Vec3, 3> edges_a = {a[1] - a[0], a[2] - a[0], a[4] - a[0]};
    const std::array<Vec3, 3> edges_b = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (int i = 0; i < 3; ++i) {
        if (apart_along(edges_a[i], a, b) || apart_along(edges_b[i], a, b)) return Overlap::none;
        for (int j = 0; j < 3; ++j)
            if (const Vec3 axis = cross(edges_a[i], edges_b[j]); axis != Vec3(0) && apart_along(axis, a, b))
                return Overlap::none;
    }
    const Transform to_local = box.to_world.inverse();
    const Vec3 low = box.cube.origin, high = low + Vec3(box.cube.size);
    const bool inside = std::ranges::all_of(b, [&](const Vec3& corner) {
        const Vec3 p = to_local.point(corner);
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x < high.x && p.y < high.y && p.z < high.z;
    });
    return inside ? Overlap::contained : Overlap::partial;
}

}  // namespace

/// Cuts away what lies outside one face of the cell after another.
bool CellOverlap::clipped_polygon_remains(std::span<const double> corners, const Cube& cell) {
    clipped_.clear();
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) clipped_.push_back(vec(corners, i));
    for (int face = 0; face < 6 && !clipped_.empty(); ++face) {
        const int axis = face / 2;
        const double side = face % 2 ? 1.0 : -1.0;
        const double plane = cell.origin[axis] + (face % 2 ? cell.size : 0.0) + side * tiny_length;
        const auto beyond = [&](const Vec3& p) { return side * (p[axis] - plane); };
        clipping_.clear();
        for (std::size_t i = 0; i < clipped_.size(); ++i) {
            const Vec3& p = clipped_[i];
            const Vec3& q = clipped_[(i + 1) % clipped_.size()];
            const double dp = beyond(p), dq = beyond(q);
            if (dp <= 0) clipping_.push_back(p);
            if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) clipping_.push_back(p + dp / (dp - dq) * (q - p));
        }
        clipped_.swap(clipping_);
    }
    return !clipped_.empty();
}

bool CellOverlap::polygon(std::span<const double> corners, const Cube& cell) {
    const double half = 0.5 * cell.size + tiny_length;
    const Vec3 center = cell.center();
    Vec3 low(1e30), high(-1e30), normal(0);
    const Vec3 first = vec(corners, 0) - center;
    Vec3 previous = first;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const Vec3 p = vec(corners, i) - center;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        const Vec3 distance = absolute(p);
        if (distance.x <= half && distance.y <= half && distance.z <= half) return true;
        normal += cross(previous - first, p - first);
        previous = p;
    }
    for (int i = 0; i < 3; ++i)
        if (low[i] > half || high[i] < -half) return false;
    if (corners.size() > 9) return clipped_polygon_remains(corners, cell);
    const Vec3 reach = absolute(normal);
    if (std::abs(dot(normal, first)) > half * (reach.x + reach.y + reach.z)) return false;
    return !apart_along_edge_axes({first, vec(corners, 3) - center, vec(corners, 6) - center}, half);
}

Overlap CellOverlap::operator()(PrimitiveId id, const Cube& cell) {
    constexpr int cone_levels = 6;
    const auto reals = scene_.reals(id);
    const auto partial_if = [](bool touches) { return touches ? Overlap::partial : Overlap::none; };
    switch (scene_.type(id)) {
        case PrimitiveType::polygon:
            return partial_if(polygon(reals, cell));
        case PrimitiveType::sphere:
        case PrimitiveType::bubble:
            return partial_if(sphere_touches(vec(reals, 0), std::abs(reals[3]), cell));
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring:
            return partial_if(turned_line_touches(turned_line(scene_, id), cell, smallest_, cone_levels));
        case PrimitiveType::instance:
        case PrimitiveType::mesh:
            return box_overlap(instances_.at(id), cell);
        default:
            return Overlap::none;
    }
}

}  // namespace infra
