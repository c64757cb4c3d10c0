#include "scene/mesh/mesh_triangles.h"

#include <algorithm>
#include <limits>

#include "common/error.h"
#include "scene/mesh/triangle_normals.h"

namespace infra {
namespace {

constexpr double largest_coordinate = 1e15;  // products must stay within double
constexpr std::size_t most_triangles = std::numeric_limits<std::int32_t>::max();

constexpr MeshTriangles::Indices none = {Corner::no_index, Corner::no_index, Corner::no_index};

bool complete(const MeshTriangles::Indices& indices) {
    return std::ranges::all_of(indices, [](std::int32_t i) { return i != Corner::no_index; });
}

void swap_ends(MeshTriangles::Indices& indices) { std::swap(indices[0], indices[2]); }

}  // namespace

PrimitiveId TriangleCollector::find_material(const Face& face) const {
    const std::string_view name = !face.names.material.empty() ? std::string_view(face.names.material)
                                  : !face.names.groups.empty() ? std::string_view(face.names.groups.front())
                                                               : std::string_view();
    if (scene_.size() == 0 || name.empty() || name == "void") return void_primitive;
    const PrimitiveId id = scene_.find_modifier(name);
    if (id == void_primitive) {
        const std::string near = nearest_name(name, scene_.modifier_names());
        throw Error(Location{std::string(face.file), face.line},
                    "undefined modifier \"" + std::string(name) + "\"",
                    near.empty() ? "" : "did you mean \"" + near + "\"?");
    }
    if (id > std::numeric_limits<std::int16_t>::max())
        throw scene_.error(id, "a mesh holds no more than 32768 primitives with its materials");
    return id;
}

void TriangleCollector::note_material(const Face& face) {
    if (face.names.changes != names_known_) {
        material_ = find_material(face);
        names_known_ = face.names.changes;
    }
    if (material_ != void_primitive) {
        any_material_ = true;
    } else if (!any_without_) {
        any_without_ = true;
        without_material_ = {std::string(face.file), face.line};
    }
}

void TriangleCollector::face(const Face& face) {
    note_material(face);
    if (face.corners.size() == 3) return add({face.corners[0], face.corners[1], face.corners[2]});
    outline_.clear();
    for (const Corner& corner : face.corners) outline_.push_back(face.vertices.positions[corner.position]);
    const Triangulation result = triangulate_(outline_, [&](std::array<int, 3> i) {
        add({face.corners[i[0]], face.corners[i[1]], face.corners[i[2]]});
    });
    if (result == Triangulation::degenerate) ++without_area_;
    if (result == Triangulation::partial) ++crossing_;
}

void TriangleCollector::add(const std::array<Corner, 3>& corners) {
    MeshTriangles::Indices at, normal, uv;
    for (int i = 0; i < 3; ++i) {
        at[i] = corners[i].position;
        normal[i] = corners[i].normal;
        uv[i] = corners[i].uv;
    }
    const auto& points = triangles_.vertices.positions;
    Vec3 own = cross(points[at[1]] - points[at[0]], points[at[2]] - points[at[1]]);
    const double size = length(own);
    if (size == 0) {
        ++without_area_;
        return;
    }
    own /= size;
    const auto& normals = triangles_.vertices.normals;
    const auto unknown = [&](std::int32_t i) { return normals[i] == Vec3(0); };
    if (complete(normal) && std::ranges::none_of(normal, unknown)) {
        const auto [turned, smooth] =
            compare_normals(own, {normals[normal[0]], normals[normal[1]], normals[normal[2]]});
        if (turned) {
            swap_ends(at);
            swap_ends(normal);
            swap_ends(uv);
        }
        if (!smooth) normal = none;
    } else {
        normal = none;
    }
    if (!complete(uv)) uv = none;
    if (triangles_.size() == most_triangles) throw Error("more than 2147483647 triangles");

    for (const std::int32_t i : at) {
        const Vec3& p = points[i];
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > largest_coordinate)
            throw Error("a coordinate beyond 1e15");
        triangles_.box.add(p);
    }
    if (complete(uv)) {
        auto& [low, high] = triangles_.uv_range;
        for (const std::int32_t i : uv) {
            for (int j = 0; j < 2; ++j) {
                low[j] = std::min(low[j], triangles_.vertices.uv[i][j]);
                high[j] = std::max(high[j], triangles_.vertices.uv[i][j]);
            }
        }
    }
    add_optional(triangles_.normals, normal);
    add_optional(triangles_.uv, uv);
    if (material_ != void_primitive || !triangles_.materials.empty()) {
        triangles_.materials.resize(triangles_.size(), std::int16_t(void_primitive));
        triangles_.materials.push_back(std::int16_t(material_));
    }
    triangles_.positions.push_back(at);
}

/// The list is begun by the first triangle that needs it.
void TriangleCollector::add_optional(std::vector<MeshTriangles::Indices>& list,
                                     const MeshTriangles::Indices& indices) const {
    if (list.empty() && indices == none) return;
    list.resize(triangles_.size(), none);
    list.push_back(indices);
}

void TriangleCollector::finish() const {
    if (any_material_ && any_without_)
        throw Error(without_material_, "a face without a material, where others have one",
                    "name one by usemtl or g, or leave out the materials");
}

}  // namespace infra
