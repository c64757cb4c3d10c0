// The triangles of a model on their way into a mesh: gathered from its faces, oriented and checked.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/mesh/face_sink.h"
#include "scene/mesh/triangulate.h"
#include "scene/scene.h"
#include "scene/surface_geometry.h"

namespace infra {

/// Which normals, texture coordinates and materials the triangles have is one list each, that is empty while
/// there are none: most of the memory that a large mesh takes is here.
struct MeshTriangles {
    using Indices = std::array<std::int32_t, 3>;

    VertexLists vertices;
    std::vector<Indices> positions;       ///< counterclockwise from the front
    std::vector<Indices> normals;         ///< no_index where the triangle is flat
    std::vector<Indices> uv;              ///< no_index where it has none
    std::vector<std::int16_t> materials;  ///< modifiers of a scene, void_primitive where it has none

    Box box;  ///< of all corners
    std::array<Uv, 2> uv_range = {Uv{1e30, 1e30},
                                  Uv{-1e30, -1e30}};  ///< lowest and highest; none: lowest above

    std::size_t size() const { return positions.size(); }
    std::int16_t material(std::size_t i) const {
        return materials.empty() ? std::int16_t(void_primitive) : materials[i];
    }
    std::array<Vec3, 3> corners(std::size_t i) const {
        const Indices& at = positions[i];
        return {vertices.positions[at[0]], vertices.positions[at[1]], vertices.positions[at[2]]};
    }
};

/// Faces in, triangles out. A triangle whose normals all point away from its front is turned over, one whose
/// normals are its own is flat, one without area is left out (as RADIANCE's obj2mesh does).
class TriangleCollector : public FaceSink {
  public:
    /// `materials` are the modifiers that usemtl, or else g, names; empty: names are not looked up.
    /// `triangles` must hold the vertices of the faces to come.
    TriangleCollector(MeshTriangles& triangles, const Scene& materials)
        : triangles_(triangles), scene_(materials) {}

    /// throws  Error for a modifier that is not defined
    void face(const Face& face) override;

    /// To be called after the last face.
    ///   throws  Error at the first face without a material if others have one, which the format cannot hold
    void finish() const;

    long long without_area() const { return without_area_; }
    long long crossing_themselves() const { return crossing_; }

  private:
    void add(const std::array<Corner, 3>& corners);
    void add_optional(std::vector<MeshTriangles::Indices>& list, const MeshTriangles::Indices& indices) const;
    PrimitiveId find_material(const Face& face) const;
    void note_material(const Face& face);

    MeshTriangles& triangles_;
    const Scene& scene_;
    Triangulator triangulate_;
    std::vector<Vec3> outline_;
    PrimitiveId material_ = void_primitive;
    int names_known_ = -1;       // FaceNames::changes that material_ is for
    Location without_material_;  // first face
    bool any_material_ = false, any_without_ = false;
    long long without_area_ = 0, crossing_ = 0;
};

}  // namespace infra
