#include "scene/cell_overlap.h"

#include <cmath>

#include "scene/surface_geometry.h"

namespace infra {
namespace {

/// Circumscribed sphere's radius over half the edge; as many digits as RADIANCE takes.
constexpr double root3 = 1.732050808;

bool sphere_touches(const Vec3& center, double radius, const Cube& cell) {
    const double bound = root3 / 2 * cell.size;
    const Vec3 offset = cell.origin + 0.5 * cell.size - center;
    const double distance2 = dot(offset, offset);
    const auto squared = [](double x) { return x * x; };
    if (distance2 > squared(radius + bound + tiny_length)) return false;
    if (bound < radius) {
        if (distance2 < squared(radius - bound - tiny_length)) return false;
        if (distance2 < squared(radius + tiny_length)) return true;
    }
    Vec3 outside(0);  // of the sphere's centre from the cell
    for (int i = 0; i < 3; ++i) {
        const double high = cell.origin[i] + cell.size;
        if (center[i] < cell.origin[i]) outside[i] = cell.origin[i] - center[i];
        if (center[i] > high) outside[i] = center[i] - high;
    }
    return dot(outside, outside) <= squared(radius + tiny_length);
}

double squared_distance(const Vec3& p, const Vec3& q) {
    const Vec3 way = q - p;
    return dot(way, way);
}

/// Squared distance of p from the straight way from a to b.
double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double whole = squared_distance(a, b), to_a = squared_distance(a, p), to_b = squared_distance(b, p);
    if (to_b > to_a ? to_b - to_a > whole : to_a - to_b > whole) return std::min(to_a, to_b);
    const double along = whole + to_a - to_b;
    return to_a - 0.25 * along * along / whole;
}

ClipBox clip_box(const Cube& cell) { return {cell.origin, cell.origin + cell.size}; }

/// The line of the surface that is closest to the cell's centre misses the cell's bounding sphere, or meets
/// the cell, or leaves it to the cell's octants.
bool turned_line_touches(const TurnedLine& line, const Cube& cell, double smallest) {
    const double half = cell.size * 0.5;
    const Vec3 center = cell.origin + half;
    Vec3 end0, end1;
    if (line.line_towards(center, end0, end1)) {
        const double reach = half * root3 + tiny_length;
        if (squared_distance(center, end0, end1) > reach * reach) return false;
        if (clip_box(cell).holds_part_of(end0, end1)) return true;
    }
    if (half < smallest) return true;
    for (int branch = 0; branch < 8; ++branch)
        if (turned_line_touches(line, cell.octant(branch), smallest)) return true;
    return false;
}

/// The cell's corners within the box, or the box's corners or edges within the cell: as in RADIANCE, a cell
/// of which only an edge pierces the box is not found.
Overlap volume_overlap(const InstanceBox& box, const Cube& cell) {
    const ClipBox local = clip_box(box.cube);
    unsigned shared = ~0u;  // sides that all corners have in common
    int outside = 0;
    for (int i = 0; i < 8; ++i) {
        const unsigned code = local.outcode(box.to_local.point(cell.corner(i)));
        outside += code != 0;
        shared &= code;
    }
    if (outside == 0) return Overlap::contained;
    if (outside < 8) return Overlap::partial;
    if (shared != 0) return Overlap::none;

    const ClipBox world = clip_box(cell);
    const auto corners = box.corners();
    shared = ~0u;
    for (const Vec3& corner : corners) {
        const unsigned code = world.outcode(corner);
        if (code == 0) return Overlap::partial;
        shared &= code;
    }
    if (shared != 0) return Overlap::none;
    for (const int from : {0, 3, 5, 6})  // no two of them share an edge
        for (const int axis : {1, 2, 4})
            if (world.holds_part_of(corners[from], corners[from ^ axis])) return Overlap::partial;
    return Overlap::none;
}

/// Asks `touches` about each octant.
template <class Test>
OctantBits each_octant(const Cube& cell, Test touches) {
    OctantBits bits;
    for (int branch = 0; branch < 8; ++branch)
        bits.touched |= std::uint8_t(touches(cell.octant(branch)) << branch);
    return bits;
}

}  // namespace

OctantBits CellOverlap::octants(PrimitiveId id, const Cube& cell, const OctantOverlap& polygons) {
    const auto reals = scene_.reals(id);
    switch (scene_.type(id)) {
        case PrimitiveType::polygon:
            polygon_corners(reals, corners_);
            return {std::uint8_t(polygons(corners_))};
        case PrimitiveType::sphere:
        case PrimitiveType::bubble: {
            const Vec3 center(reals[0], reals[1], reals[2]);
            const double radius = std::abs(reals[3]);
            return each_octant(cell, [&](const Cube& o) { return sphere_touches(center, radius, o); });
        }
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring: {
            const TurnedLine line = turned_line(scene_, id);
            return each_octant(cell, [&](const Cube& o) { return turned_line_touches(line, o, smallest_); });
        }
        case PrimitiveType::instance:
        case PrimitiveType::mesh: {
            const InstanceBox& box = instances_.at(id);
            OctantBits bits;
            for (int branch = 0; branch < 8; ++branch) {
                const Overlap overlap = volume_overlap(box, cell.octant(branch));
                bits.touched |= std::uint8_t((overlap != Overlap::none) << branch);
                bits.contained |= std::uint8_t((overlap == Overlap::contained) << branch);
            }
            return bits;
        }
        default:
            return {};
    }
}

/// It is the first octant of a cell of twice its size.
Overlap CellOverlap::operator()(PrimitiveId id, const Cube& cell) {
    const Cube twice{cell.origin, 2 * cell.size};
    return octants(id, twice, OctantOverlap(twice))[0];
}

}  // namespace infra
