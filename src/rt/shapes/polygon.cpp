#include "rt/shapes/polygon.h"

#include <algorithm>

namespace infra {

std::span<const double> distinct_vertices(std::span<const double> vertices) {
    const std::size_t count = vertices.size() / 3;
    const auto* last = vertices.data() + 3 * (count - 1);
    const Vec3 gap{vertices[0] - last[0], vertices[1] - last[1], vertices[2] - last[2]};
    return vertices.first(3 * (count > 3 && length(gap) <= same_place ? count - 1 : count));
}

PolygonPlane polygon_plane(std::span<const double> vertices) {
    const std::size_t count = vertices.size() / 3;
    const auto vertex = [&](std::size_t i) {
        return Vec3(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
    };
    PolygonPlane plane;
    if (count < 3) return plane;
    Vec3 sum{0};
    for (std::size_t i = 2; i < count; ++i) sum += cross(vertex(i - 1) - vertex(0), vertex(i) - vertex(0));
    const double doubled = length(sum);
    if (!(doubled > 0)) return plane;
    plane.normal = sum / doubled;
    plane.area = 0.5 * doubled;
    for (std::size_t i = 0; i < count; ++i) plane.offset += dot(plane.normal, vertex(i));
    plane.offset /= static_cast<double>(count);
    return plane;
}

Triangle::Triangle(const Vec3& a, const Vec3& b, const Vec3& c, int surface_index) : surface(surface_index) {
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 n = cross(ab, ac);
    int k = std::fabs(n.y) > std::fabs(n.x) ? 1 : 0;
    if (std::fabs(n.z) > std::fabs(n[k])) k = 2;
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    axis = static_cast<std::uint8_t>(k);
    reversed = n[k] < 0;
    plane_u = n[u] / n[k];
    plane_v = n[v] / n[k];
    plane_d = a[k] + plane_u * a[u] + plane_v * a[v];
    const double area = n[k];  // of the projected parallelogram, signed
    b_u = ac[v] / area;
    b_v = -ac[u] / area;
    b_d = (a[v] * ac[u] - a[u] * ac[v]) / area;
    c_u = -ab[v] / area;
    c_v = ab[u] / area;
    c_d = (a[u] * ab[v] - a[v] * ab[u]) / area;
}

TriangleLimits::TriangleLimits(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    for (int i = 0; i < 3; ++i) {
        lo[i] = std::min(std::min(a[i], b[i]), c[i]);
        hi[i] = std::max(std::max(a[i], b[i]), c[i]);
    }
    const Vec3 n = cross(b - a, c - a);
    // As for all polygons, too small an area to be squared is none.
    doubled_area = dot(n, n) > 0 ? std::max(std::max(std::fabs(n.x), std::fabs(n.y)), std::fabs(n.z)) : 0;
}

double TriangleLimits::uncertainty() const {
    double reach = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
        reach = std::max(reach, std::max(-lo[i], hi[i]));
        size = std::max(size, hi[i] - lo[i]);
    }
    // A barycentric coordinate is a sum of three terms of at most reach size / area, the plane's slope wrong
    // by size^2 / area of the last place.
    return std::min(32 * 0x1p-53 * reach * size * size / doubled_area, size);
}

Vec3 Triangle::normal() const {
    Vec3 n;
    n[axis] = 1;
    n[(axis + 1) % 3] = plane_u;
    n[(axis + 2) % 3] = plane_v;
    return n * ((reversed ? -1.0 : 1.0) / length(n));
}

}  // namespace infra
