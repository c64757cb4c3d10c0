#include "scene/mesh/mesh_report.h"

#include <algorithm>

#include "common/format.h"
#include "scene/mesh/direction_code.h"

namespace infra {
namespace {

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * double(part) / double(whole);
}

struct Cells {
    std::size_t empty = 0, full = 0, members = 0;
};

void count_cells(const Octree& tree, OctreeNode node, Cells& cells) {
    if (Octree::is_inner(node)) {
        for (int branch = 0; branch < 8; ++branch) count_cells(tree, tree.child(node, branch), cells);
    } else if (Octree::is_leaf(node)) {
        ++cells.full;
        cells.members += tree.set(node).size();
    } else {
        ++cells.empty;
    }
}

}  // namespace

std::string describe(const PackedMesh& mesh) {
    const MeshPatches& packed = mesh.patches;
    std::size_t local = 0, all = 0;
    for (const MeshPatches::Patch& patch : packed.patches) {
        local += patch.local.size();
        all += patch.local.size() + patch.joining.size() + patch.double_joining.size();
    }
    const std::size_t vertices = packed.positions.size();
    const auto with_normal =
        std::size_t(std::ranges::count_if(packed.normals, [](auto code) { return code != no_direction; }));
    const auto with_uv =
        std::size_t(std::ranges::count_if(packed.uv, [](const auto& uv) { return uv[0] != 0; }));
    Cells cells;
    count_cells(mesh.tree, mesh.tree.root, cells);
    const double set_size = cells.full == 0 ? 0.0 : double(cells.members) / double(cells.full);
    return formatted("triangles  %zu, %.1f%% of them within a patch\n", all, percent(local, all)) +
           formatted("patches    %zu\n", packed.patches.size()) +
           formatted("vertices   %zu, %.1f%% with a normal, %.1f%% with texture coordinates\n", vertices,
                     percent(with_normal, vertices), percent(with_uv, vertices)) +
           formatted("cells      %zu, %.1f%% empty, on average %.2f triangles in the others\n",
                     cells.full + cells.empty, percent(cells.empty, cells.full + cells.empty), set_size);
}

}  // namespace infra
