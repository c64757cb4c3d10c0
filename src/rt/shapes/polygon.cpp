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

std::array<Vec3, 3> Triangle::corners() const {
    // The second and third barycentric coordinates are (0, 0), (1, 0) and (0, 1) there.
    const double determinant = b_u * c_v - b_v * c_u;
    constexpr double coordinates[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const double second = coordinates[i][0] - b_d, third = coordinates[i][1] - c_d;
        Vec3& p = corners[i];
        p[u] = (second * c_v - third * b_v) / determinant;
        p[v] = (third * b_u - second * c_u) / determinant;
        p[axis] = plane_d - plane_u * p[u] - plane_v * p[v];
    }
    return corners;
}

double Triangle::uncertainty() const {
    double reach = 0, size = 0;
    const std::array<Vec3, 3> corner = corners();
    for (int i = 0; i < 3; ++i) {
        const auto [lo, hi] = std::minmax({corner[0][i], corner[1][i], corner[2][i]});
        reach = std::max({reach, -lo, hi});
        size = std::max(size, hi - lo);
    }
    // A barycentric coordinate is a sum of three terms of at most reach size / area, the plane's slope wrong
    // by size^2 / area of the last place.
    const double area = 1 / std::fabs(b_u * c_v - b_v * c_u);
    return std::min(32 * 0x1p-53 * reach * size * size / area, size);
}

Vec3 Triangle::normal() const {
    Vec3 n;
    n[axis] = 1;
    n[(axis + 1) % 3] = plane_u;
    n[(axis + 2) % 3] = plane_v;
    return n * ((reversed ? -1.0 : 1.0) / length(n));
}

}  // namespace infra
