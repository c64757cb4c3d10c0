// Flat polygons: triangles in a form of their own, because meshes are made of them; all others by a crossing
// test in the plane of two axes, which copes with concave outlines and with holes cut by seams.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rt/shapes/hit_state.h"

namespace infra {

/// Plane of a polygon.
struct PolygonPlane {
    Vec3 normal{0};     ///< unit; counter-clockwise vertices face the viewer
    double offset = 0;  ///< of the plane along the normal, the mean over all vertices
    double area = 0;    ///< 0: a polygon that no ray can meet
};

/// The vertices without a last one that repeats the first.
std::span<const double> distinct_vertices(std::span<const double> vertices);

/// Averages a polygon that is not quite flat. vertices: three numbers each, the last may repeat the first.
PolygonPlane polygon_plane(std::span<const double> vertices);

/// A triangle projected along the axis that its normal is nearest to: 80 bytes, no vertices.
/// source: Wald, "Realtime Ray Tracing and Interactive Global Illumination" (PhD thesis, 2004), 7.1.
struct Triangle {
    double plane_u, plane_v, plane_d;  ///< plane: p[axis] + plane_u p[u] + plane_v p[v] = plane_d
    double b_u, b_v, b_d;              ///< second barycentric coordinate: b_u p[u] + b_v p[v] + b_d
    double c_u, c_v, c_d;              ///< third
    int surface;
    std::uint8_t axis;
    bool reversed;  ///< the normal points against the axis

    Triangle() = default;
    /// The corners must not lie on a line.
    Triangle(const Vec3& a, const Vec3& b, const Vec3& c, int surface_index);

    void intersect(const Vec3& origin, const Vec3& direction, const SurfaceTable& table, std::uint32_t shape,
                   HitState& state) const {
        constexpr int next[] = {1, 2, 0, 1};
        const int u = next[axis], v = next[axis + 1];
        const double slope = direction[axis] + plane_u * direction[u] + plane_v * direction[v];
        if (std::fabs(slope) <= same_place) return;
        const double t = (plane_d - origin[axis] - plane_u * origin[u] - plane_v * origin[v]) / slope;
        if (t <= same_place || t > state.distance + same_place) return;
        constexpr double slack = 1e-9;  // closes the seam between neighbours against rounding
        const double pu = origin[u] + t * direction[u], pv = origin[v] + t * direction[v];
        const double second = b_u * pu + b_v * pv + b_d;
        if (second < -slack) return;
        const double third = c_u * pu + c_v * pv + c_d;
        if (third < -slack || second + third > 1.0 + slack) return;
        offer_hit(state, table, t, (slope < 0) != reversed, surface, shape);
    }

    /// Unit normal.
    Vec3 normal() const;
};

/// What the corners of a triangle tell without it.
struct TriangleLimits {
    Vec3 lo, hi;
    double doubled_area;  ///< projected along the axis that the normal is nearest to; 0: it cannot be met

    explicit TriangleLimits(const std::array<Vec3, 3>& corners);
    /// How far beyond its corners rounding may let the triangle be met: much for a sliver far from the
    /// origin, no more than the triangle's size.
    double uncertainty() const;
};

struct Polygon {
    Vec3 normal;  ///< unit
    double offset;
    const double* corners;  ///< two coordinates for each vertex, in the plane of the axes x_axis and y_axis
    int corner_count;
    int surface;
    int x_axis, y_axis;

    void intersect(const Vec3& origin, const Vec3& direction, const SurfaceTable& table, std::uint32_t shape,
                   HitState& state) const {
        const double cosine = -dot(direction, normal);
        if (std::fabs(cosine) <= same_place) return;
        const double t = (dot(origin, normal) - offset) / cosine;
        if (t <= same_place || t > state.distance + same_place) return;
        if (contains(origin[x_axis] + direction[x_axis] * t, origin[y_axis] + direction[y_axis] * t))
            offer_hit(state, table, t, cosine > 0, surface, shape);
    }

    /// Even-odd rule over the outline; the outline itself, within `same_place`, belongs to the polygon.
    bool contains(double x, double y) const {
        bool inside = false;
        const double* previous = corners + 2 * (corner_count - 1);
        for (const double* corner = corners; corner != corners + 2 * corner_count;
             previous = corner, corner += 2) {
            const double dx = previous[0] - corner[0], dy = previous[1] - corner[1];
            const double px = x - corner[0], py = y - corner[1];
            const double side = dx * py - dy * px;
            const double size2 = dx * dx + dy * dy;
            if (side * side <= same_place * same_place * size2) {  // on the edge's line
                const double along = dx * px + dy * py;
                if (along >= 0 && along <= size2) return true;
            }
            if ((py < 0) != (y < previous[1]) && (side > 0) == (dy > 0)) inside = !inside;
        }
        return inside;
    }
};

}  // namespace infra
