#include "rt/shapes/facets.h"

#include "common/error.h"
#include "scene/mesh/mesh.h"

namespace infra {
namespace {

/// Weights of a triangle's corners at a point of its plane.
std::array<double, 3> barycentric(const std::array<Vec3, 3>& corner, const Vec3& point) {
    const Vec3 n = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double area2 = dot(n, n);
    const double second = dot(cross(point - corner[0], corner[2] - corner[0]), n) / area2;
    const double third = dot(cross(corner[1] - corner[0], point - corner[0]), n) / area2;
    return {1 - second - third, second, third};
}

}  // namespace

Facets::Facets(Mesh& mesh, std::span<const int> surface_of)
    : positions_(std::move(mesh.positions)), uv_(std::move(mesh.uv)) {
    if (surface_of.back() >= 1 << 30) throw Error("too many surfaces in the scene");
    normals_.reserve(mesh.normals.size());
    for (const Vec3& n : mesh.normals)
        normals_.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    facets_.reserve(mesh.triangles.size());
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        const int surface = triangle.material == Mesh::no_material
                                ? surface_of.back()
                                : surface_of[static_cast<std::size_t>(triangle.material)];
        const Facet facet{{triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]},
                          static_cast<std::uint32_t>(surface) & 0x3fffffffu,
                          triangle.smooth && !normals_.empty(),
                          triangle.mapped && !uv_.empty()};
        const auto [a, b, c] = corners(facet);
        if (length(cross(b - a, c - a)) > 0) facets_.push_back(facet);
    }
}

Vec3 Facets::normal(std::size_t i) const {
    const auto [a, b, c] = corners(facets_[i]);
    return normalize(cross(b - a, c - a));
}

Facets::Detail Facets::detail(std::size_t i, const Vec3& point) const {
    const Facet& facet = facets_[i];
    Detail detail{normal(i), {0, 0}};
    if (!facet.smooth && !facet.mapped) return detail;
    const std::array<double, 3> weight = barycentric(corners(facet), point);
    if (facet.smooth) {
        Vec3 sum{0};
        for (int k = 0; k < 3; ++k) {
            const auto& n = normals_[facet.vertex[k]];
            sum += Vec3{n[0], n[1], n[2]} * weight[static_cast<std::size_t>(k)];
        }
        if (const double size = length(sum); size > 0) detail.normal = sum / size;
    }
    if (facet.mapped)
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 2; ++axis)
                detail.uv[axis] += weight[static_cast<std::size_t>(k)] *
                                   uv_[facet.vertex[k]][static_cast<std::size_t>(axis)];
    return detail;
}

}  // namespace infra
