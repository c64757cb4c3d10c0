// Faces as polygons of RADIANCE's scene language.
#pragma once

#include <iosfwd>
#include <string>

#include "scene/mesh/face_sink.h"
#include "scene/mesh/material_rules.h"
#include "scene/mesh/triangulate.h"

namespace infra {

struct RadSettings {
    std::string object;                    ///< name of polygons that the file has none for; "": by groups
    const MaterialRules* rules = nullptr;  ///< none: usemtl, or else g, or else "white"
    bool flat = false;                     ///< normals of vertices are ignored
};

/// Writes each face as it comes: plane ones as they are, others and those with normals in triangles, with a
/// texture of tmesh.cal where their normals are not the triangle's own.
class RadOutput : public FaceSink {
  public:
    RadOutput(std::ostream& out, RadSettings settings) : out_(out), settings_(std::move(settings)) {}

    void face(const Face& face) override;
    void comment(std::string_view text) override;

    long long without_area() const { return without_area_; }

  private:
    std::string material_of(const Face& face) const;
    std::string name_of(const Face& face) const;
    void split(const Face& face);
    void triangle(const Face& face, std::array<Corner, 3> corners);
    void texture(const Face& face, const std::array<Corner, 3>& corners);
    void begin_polygon(const Face& face, std::string_view modifier, std::size_t corners);
    void point(const Vec3& p);

    std::ostream& out_;
    RadSettings settings_;
    Triangulator triangulate_;
    std::vector<Vec3> outline_;
    std::string material_, name_;  // of the current face
    int names_known_ = -1;         // FaceNames::changes that name_ is for
    long long without_area_ = 0;
};

}  // namespace infra
