#include "scene/mesh/mesh_writer.h"

#include <algorithm>
#include <ostream>

#include "common/error.h"
#include "scene/byte_writer.h"
#include "scene/mesh/direction_code.h"
#include "scene/octree_format.h"
#include "scene/octree_section.h"
#include "scene/scene_section.h"

namespace infra {
namespace {

/// Makes a tree whose sets name packed triangles from one whose sets name triangles of a model. Walks the
/// cells, and the sets, backwards: that is the order in which RADIANCE packs.
class TreePacker {
  public:
    TreePacker(const MeshTriangles& triangles, const Octree& tree, PackedMesh& mesh)
        : tree_(tree), mesh_(mesh), packer_(triangles, mesh.cube), numbers_(triangles.size(), unpacked) {}

    void run() {
        mesh_.tree.root = cell(tree_.root);
        for (std::size_t i = 0; i < numbers_.size(); ++i)  // left out of a crowded cell, but of the mesh
            if (numbers_[i] == unpacked) packer_.add(i);
        mesh_.patches = packer_.take();
    }

  private:
    static constexpr PrimitiveId unpacked = -1;

    OctreeNode cell(OctreeNode node) {
        if (Octree::is_inner(node)) {
            std::array<OctreeNode, 8> children;
            for (int branch = 8; branch-- > 0;) children[branch] = cell(tree_.child(node, branch));
            return mesh_.tree.add_inner(children);
        }
        if (!Octree::is_leaf(node)) return empty_node;
        set_.clear();
        const auto members = tree_.set(node);
        for (std::size_t i = members.size(); i-- > 0;) {
            PrimitiveId& number = numbers_[members[i]];
            if (number == unpacked) number = PrimitiveId(packer_.add(std::size_t(members[i])));
            set_.push_back(number);
        }
        std::ranges::sort(set_);
        return mesh_.tree.add_leaf(set_);
    }

    const Octree& tree_;
    PackedMesh& mesh_;
    PatchPacker packer_;
    std::vector<PrimitiveId> numbers_;  // by triangle of the model
    std::vector<PrimitiveId> set_;
};

class MeshWriter {
  public:
    MeshWriter(std::ostream& stream, const PackedMesh& mesh) : out_(stream), mesh_(mesh) {}

    void write(const std::vector<std::string>& header, const Scene& materials);

  private:
    void fraction(std::uint32_t value) { out_.integer(value, 4); }
    void patch(std::size_t index);
    void vertices(std::size_t begin, std::size_t end);
    void local_triangles(const std::vector<MeshPatches::Local>& triangles);
    PrimitiveId materials_in_use() const;

    ByteWriter out_;
    const PackedMesh& mesh_;
};

void MeshWriter::vertices(std::size_t begin, std::size_t end) {
    const MeshPatches& all = mesh_.patches;
    int flags = PatchFlag::positions;
    for (std::size_t i = begin; i < end; ++i) {
        if (all.normals[i] != no_direction) flags |= PatchFlag::normals;
        if (all.uv[i][0] != 0) flags |= PatchFlag::uv;
    }
    out_.integer(flags, 1);
    out_.integer(std::int64_t(end - begin), 2);
    for (std::size_t i = begin; i < end; ++i)
        for (const std::uint32_t value : all.positions[i]) fraction(value);
    for (std::size_t i = begin; i < end && flags & PatchFlag::normals; ++i) fraction(all.normals[i]);
    for (std::size_t i = begin; i < end && flags & PatchFlag::uv; ++i)
        for (const std::uint32_t value : all.uv[i]) fraction(value);
}

/// One material for all triangles of the patch if that does, else one each.
void MeshWriter::local_triangles(const std::vector<MeshPatches::Local>& triangles) {
    out_.integer(std::int64_t(triangles.size()), 2);
    for (const auto& triangle : triangles)
        for (const std::uint8_t vertex : triangle.vertex) out_.byte(vertex);
    const std::int16_t first = triangles.empty() ? std::int16_t(0) : triangles.front().material;
    const bool same = std::ranges::all_of(triangles, [&](const auto& t) { return t.material == first; });
    out_.integer(same ? 1 : std::int64_t(triangles.size()), 2);
    if (same)
        out_.integer(first, 2);
    else
        for (const auto& triangle : triangles) out_.integer(triangle.material, 2);
}

void MeshWriter::patch(std::size_t index) {
    const MeshPatches::Patch& patch = mesh_.patches.patches[index];
    const std::size_t begin = index * most_patch_vertices;
    vertices(begin, std::min(begin + most_patch_vertices, mesh_.patches.positions.size()));
    local_triangles(patch.local);
    out_.integer(std::int64_t(patch.joining.size()), 2);
    for (const auto& triangle : patch.joining) {
        out_.integer(triangle.far, 4);
        for (const std::uint8_t vertex : triangle.vertex) out_.byte(vertex);
        out_.integer(triangle.material, 2);
    }
    out_.integer(std::int64_t(patch.double_joining.size()), 2);
    for (const auto& triangle : patch.double_joining) {
        for (const std::uint32_t vertex : triangle.far) out_.integer(vertex, 4);
        out_.byte(triangle.vertex);
        out_.integer(triangle.material, 2);
    }
}

/// All up to the last one that a triangle has.
PrimitiveId MeshWriter::materials_in_use() const {
    PrimitiveId last = void_primitive;
    const auto note = [&](const auto& triangles) {
        for (const auto& triangle : triangles) last = std::max<PrimitiveId>(last, triangle.material);
    };
    for (const MeshPatches::Patch& patch : mesh_.patches.patches) {
        note(patch.local);
        note(patch.joining);
        note(patch.double_joining);
    }
    return last + 1;
}

void MeshWriter::write(const std::vector<std::string>& header, const Scene& materials) {
    write_section_header(out_, header, mesh_format);
    out_.integer(mesh_magic + written_id_size, 2);
    write_cube(out_, mesh_.cube);
    const auto& [low, high] = mesh_.patches.uv_range;
    for (int i = 0; i < 2; ++i) {
        out_.real(low[i]);
        out_.real(high[i]);
    }
    write_tree(out_, mesh_.tree);
    write_scene_section(out_, materials, materials_in_use());
    out_.integer(std::int64_t(mesh_.patches.patches.size()), 4);
    for (std::size_t i = 0; i < mesh_.patches.patches.size(); ++i) patch(i);
    out_.finish();
}

}  // namespace

PackedMesh pack_mesh(const MeshTriangles& triangles, const MeshLimits& limits, const WarningSink& warn) {
    if (triangles.size() == 0) throw Error("no triangles, so no mesh");
    PackedMesh mesh;
    mesh.cube = mesh_cube(triangles.box);
    TreePacker(triangles, build_mesh_tree(triangles, mesh.cube, limits, warn), mesh).run();
    return mesh;
}

void write_mesh(std::ostream& out, const std::vector<std::string>& header, const PackedMesh& mesh,
                const Scene& materials) {
    MeshWriter(out, mesh).write(header, materials);
}

}  // namespace infra
