#include "rt/shapes/polygon.h"

namespace infra {

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
    const Vec3 scaled_normal = cross(ab, ac);
    const double squared = dot(scaled_normal, scaled_normal);
    normal = scaled_normal / std::sqrt(squared);
    offset = (dot(normal, a) + dot(normal, b) + dot(normal, c)) / 3.0;
    u_axis = cross(ac, scaled_normal) / squared;
    v_axis = cross(scaled_normal, ab) / squared;
    u0 = -dot(a, u_axis);
    v0 = -dot(a, v_axis);
}

}  // namespace infra
