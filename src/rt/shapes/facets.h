// The triangles of a mesh. They share their vertices, which may have normals and texture coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/large_pages.h"
#include "rt/shapes/hit_state.h"

namespace infra {

struct Mesh;

class Facets {
  public:
    struct Facet {
        std::uint32_t vertex[3];
        std::uint32_t surface : 30;
        std::uint32_t smooth : 1;  ///< its vertices have normals
        std::uint32_t mapped : 1;  ///< its vertices have texture coordinates
    };

    Facets() = default;
    /// Takes positions, normals and texture coordinates out of the mesh. Triangles without area are left out.
    ///   surface_of  by material of the mesh, and last for what has none
    Facets(Mesh& mesh, std::span<const int> surface_of);

    LargeVector<Facet>& all() { return facets_; }
    std::array<Vec3, 3> corners(const Facet& facet) const {
        return {positions_[facet.vertex[0]], positions_[facet.vertex[1]], positions_[facet.vertex[2]]};
    }

    /// Neighbours compute the side of their edge that a ray passes with the same numbers: there is no seam.
    /// source: Segura & Feito, "Algorithms to Test Ray-Triangle Intersection, Comparative Study" (2001).
    void intersect(std::size_t i, const Vec3& origin, const Vec3& direction, const SurfaceTable& table,
                   std::uint32_t shape, HitState& state) const {
        const Facet& facet = facets_[i];
        const Vec3 a = positions_[facet.vertex[0]] - origin;
        const Vec3 b = positions_[facet.vertex[1]] - origin;
        const Vec3 c = positions_[facet.vertex[2]] - origin;
        const double ab = dot(direction, cross(a, b));
        const double bc = dot(direction, cross(b, c));
        if ((ab < 0 && bc > 0) || (ab > 0 && bc < 0)) return;
        const double ca = dot(direction, cross(c, a));
        if ((ca < 0 && (ab > 0 || bc > 0)) || (ca > 0 && (ab < 0 || bc < 0))) return;
        const Vec3 n = cross(b - a, c - a);
        const double slope = dot(direction, n);
        if (slope == 0) return;
        offer_hit(state, table, dot(a, n) / slope, slope < 0, static_cast<int>(facet.surface), shape);
    }

    /// Unit normal of the plane; counterclockwise vertices face the viewer.
    Vec3 normal(std::size_t i) const;

    /// What the vertices say of a point on a facet.
    struct Detail {
        Vec3 normal;  ///< unit, interpolated; that of the plane where the vertices have none
        double uv[2];
    };
    Detail detail(std::size_t i, const Vec3& point) const;

  private:
    LargeVector<Facet> facets_;
    std::vector<Vec3> positions_;
    std::vector<std::array<float, 3>> normals_;  // as many as positions or none
    std::vector<std::array<double, 2>> uv_;      // as many as positions or none
};

}  // namespace infra
