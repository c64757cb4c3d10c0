#include <algorithm>

#include "common/raypath.h"
#include "scene/byte_reader.h"
#include "scene/mesh/direction_code.h"
#include "scene/mesh/mesh.h"
#include "scene/octree_format.h"
#include "scene/octree_section.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

constexpr double fractions = 4294967296.0;  // of a cube's side or of a coordinate's range

struct Range {
    double low = 0, high = 0;

    double at(std::uint32_t fraction) const { return low + (high - low) * ((fraction + 0.5) / fractions); }
};

/// Triangles of cells are not kept, as the ray tracer has its own hierarchy, but must be of a patch there is.
class LargestPatch : public TreeVisitor {
  public:
    explicit LargestPatch(const ByteReader& in) : in_(in) {}

    OctreeNode leaf(std::span<const std::int64_t> members) override {
        for (const std::int64_t triangle : members) {
            if (triangle < 0) in_.fail_damaged("a cell holds a triangle that does not exist");
            patch = std::max(patch, triangle >> triangle_bits);
        }
        return empty_node;
    }
    OctreeNode inner(std::span<const OctreeNode, 8>) override { return empty_node; }

    std::int64_t patch = -1;

  private:
    const ByteReader& in_;
};

class MeshReader {
  public:
    explicit MeshReader(ByteReader& in) : in_(in) {}

    Mesh read();

  private:
    /// A number of things; bounded by the format, so that memory is by what the file holds.
    int count(int most, const char* what);
    std::uint32_t fraction() { return static_cast<std::uint32_t>(in_.integer(4)); }
    /// Vertex numbers as the file has them, patch << 8 | number, until link_vertices().
    std::uint32_t local_vertex();
    std::uint32_t far_vertex() { return static_cast<std::uint32_t>(in_.integer(4)); }
    std::int32_t material();

    void read_patch();
    void read_vertices(int flags);
    void read_local_triangles();
    void link_vertices();

    ByteReader& in_;
    Mesh mesh_;
    std::array<Range, 2> uv_range_;
    std::vector<bool> has_uv_;                   // by vertex; empty if none has
    std::vector<std::uint32_t> patch_begin_{0};  // first vertex of each patch, and the end of the last
};

int MeshReader::count(int most, const char* what) {
    const auto n = in_.integer(2);
    if (n < 0 || n > most) in_.fail_damaged(std::string("a patch with a senseless number of ") + what);
    return int(n);
}

std::uint32_t MeshReader::local_vertex() {
    return std::uint32_t(patch_begin_.size() - 2) << vertex_bits | std::uint32_t(in_.byte());
}

std::int32_t MeshReader::material() {
    const auto number = in_.integer(2);
    if (number < Mesh::no_material || number >= std::int64_t(mesh_.materials.size()))
        in_.fail_damaged("a triangle's material does not exist");
    return std::int32_t(number);
}

void MeshReader::read_vertices(int flags) {
    const int vertices = count(most_patch_vertices, "vertices");
    const std::size_t end = patch_begin_.back() + std::size_t(vertices);
    patch_begin_.push_back(std::uint32_t(end));
    const double unit = mesh_.cube.size / fractions;
    for (int i = 0; i < vertices; ++i) {
        const double x = fraction(), y = fraction(), z = fraction();
        mesh_.positions.push_back(mesh_.cube.origin + unit * Vec3(x + 0.5, y + 0.5, z + 0.5));
    }
    if (flags & PatchFlag::normals) {
        mesh_.normals.resize(end - std::size_t(vertices), Vec3(0));
        for (int i = 0; i < vertices; ++i) mesh_.normals.push_back(decode_direction(fraction()));
    }
    if (flags & PatchFlag::uv) {
        mesh_.uv.resize(end - std::size_t(vertices));
        has_uv_.resize(end - std::size_t(vertices));
        for (int i = 0; i < vertices; ++i) {
            const std::uint32_t u = fraction(), v = fraction();
            mesh_.uv.push_back({uv_range_[0].at(u), uv_range_[1].at(v)});
            has_uv_.push_back(u != 0);
        }
    }
}

void MeshReader::read_local_triangles() {
    const std::size_t begin = mesh_.triangles.size();
    const int triangles = count(most_local_triangles, "triangles");
    for (int i = 0; i < triangles; ++i) {
        const std::uint32_t a = local_vertex(), b = local_vertex(), c = local_vertex();
        mesh_.triangles.push_back({{a, b, c}});
    }
    // One material for all of them, or one each.
    const bool each = in_.integer(2) > 1;
    for (int i = 0; i < triangles; ++i)
        mesh_.triangles[begin + std::size_t(i)].material =
            each || i == 0 ? material() : mesh_.triangles[begin].material;
    if (triangles == 0 && !each) in_.integer(2);
}

void MeshReader::read_patch() {
    const auto flags = in_.integer(1);
    if (!(flags & PatchFlag::positions) ||
        flags & ~(PatchFlag::positions | PatchFlag::normals | PatchFlag::uv))
        in_.fail_damaged("a patch of no known sort");
    read_vertices(int(flags));
    read_local_triangles();
    for (int i = count(most_joining_triangles, "joining triangles"); i > 0; --i) {
        const std::uint32_t a = far_vertex(), b = local_vertex(), c = local_vertex();
        mesh_.triangles.push_back({{a, b, c}, material()});
    }
    for (int i = count(most_joining_triangles, "joining triangles"); i > 0; --i) {
        const std::uint32_t a = far_vertex(), b = far_vertex(), c = local_vertex();
        mesh_.triangles.push_back({{a, b, c}, material()});
    }
}

/// From numbers in patches to numbers in the whole mesh, which all patches must have been read for.
void MeshReader::link_vertices() {
    const auto has_normal = [&](std::uint32_t i) { return mesh_.normals[i] != Vec3(0); };
    const auto has_uv = [&](std::uint32_t i) { return has_uv_[i]; };
    for (Mesh::Triangle& triangle : mesh_.triangles) {
        for (std::uint32_t& vertex : triangle.vertex) {
            const std::size_t patch = vertex >> vertex_bits;
            const std::uint32_t local = vertex & (most_patch_vertices - 1);
            if (patch + 1 >= patch_begin_.size() || local >= patch_begin_[patch + 1] - patch_begin_[patch])
                in_.fail_damaged("a triangle's vertex does not exist");
            vertex = patch_begin_[patch] + local;
        }
        triangle.smooth = !mesh_.normals.empty() && std::ranges::all_of(triangle.vertex, has_normal);
        triangle.mapped = !mesh_.uv.empty() && std::ranges::all_of(triangle.vertex, has_uv);
    }
}

Mesh MeshReader::read() {
    mesh_.header = read_section_header(in_, mesh_format, "mesh");
    const int id_size = read_id_size(in_, mesh_magic, "mesh");
    mesh_.cube = read_cube(in_);
    for (Range& range : uv_range_) {
        range.low = in_.real();
        range.high = in_.real();
    }
    LargestPatch tree(in_);
    read_tree(in_, id_size, tree);

    read_scene_section(in_, mesh_.scene, id_size);
    for (PrimitiveId id = 0; id < mesh_.scene.size(); ++id) {
        if (!mesh_.scene.type_info(id).is_modifier())
            in_.fail_damaged("among its materials is a " + std::string(mesh_.scene.type_info(id).name));
        mesh_.materials.push_back(id);
    }
    const auto patches = in_.integer(4);
    if (patches < 0 || patches > most_patches) in_.fail_damaged("a senseless number of patches");
    if (tree.patch >= patches) in_.fail_damaged("a cell holds a triangle that does not exist");
    for (std::int64_t i = 0; i < patches; ++i) read_patch();
    if (!mesh_.normals.empty()) mesh_.normals.resize(mesh_.positions.size(), Vec3(0));
    if (!mesh_.uv.empty()) {
        mesh_.uv.resize(mesh_.positions.size());
        has_uv_.resize(mesh_.positions.size());
    }
    link_vertices();
    return std::move(mesh_);
}

}  // namespace

Mesh load_mesh(const std::string& name, const WarningSink& warn) {
    const std::string path = require_library_file(name, "mesh file");
    const FileHandle stream = open_scene_file(path, "mesh");
    ByteReader in(stream.get(), path, "mesh");
    Mesh mesh = MeshReader(in).read();
    if (mesh.triangles.empty()) warn(path + ": an empty mesh");
    return mesh;
}

}  // namespace infra
