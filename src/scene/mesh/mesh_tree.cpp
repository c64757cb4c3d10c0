#include "scene/mesh/mesh_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "scene/octant_overlap.h"

namespace infra {
namespace {

/// After this many divisions that leave all triangles together in more than one part (they are doubles of
/// each other, or smaller than the tolerance), the cell is left as it is: the next ones would multiply cells
/// without end.
constexpr int most_fruitless_divisions = 6;

class Builder {
  public:
    Builder(Octree& tree, const MeshTriangles& triangles, const Cube& cube, const MeshLimits& limits)
        : tree_(tree),
          triangles_(triangles),
          most_(std::size_t(limits.triangles)),
          smallest_(cube.size / limits.resolution - tiny_length) {
        members_.resize(triangles.size());
        std::iota(members_.begin(), members_.end(), 0);
    }

    /// The node of a cell with the triangles from members_[begin] on.
    OctreeNode build(const Cube& cell, std::size_t begin, int fruitless);

    /// Triangles that met in the most crowded cell.
    std::size_t largest() const { return largest_; }

  private:
    bool divides(const Cube& cell, std::size_t count, int fruitless) const;

    Octree& tree_;
    const MeshTriangles& triangles_;
    std::size_t most_;
    double smallest_;
    std::vector<PrimitiveId> members_;   // of the cells on the way from the root, the current one's last
    std::vector<std::uint8_t> octants_;  // that they touch, in cells that are being divided
    std::size_t largest_ = 0;
};

bool Builder::divides(const Cube& cell, std::size_t count, int fruitless) const {
    const double half = 0.5 * cell.size;
    if (half < tiny_length || fruitless >= most_fruitless_divisions) return false;
    return (count > most_ && half >= smallest_) || (count > Octree::largest_set && half >= smallest_ / 256);
}

OctreeNode Builder::build(const Cube& cell, std::size_t begin, int fruitless) {
    const std::size_t count = members_.size() - begin;
    if (!divides(cell, count, fruitless)) {
        largest_ = std::max(largest_, count);
        return tree_.add_leaf(std::span(members_).subspan(begin, std::min(count, Octree::largest_set)));
    }
    const OctantOverlap overlap(cell);
    const std::size_t first_octants = octants_.size();
    std::array<std::size_t, 8> counts{};
    for (std::size_t i = begin; i < begin + count; ++i) {
        const auto corners = triangles_.corners(std::size_t(members_[i]));
        const unsigned touched = overlap(std::span(corners));
        octants_.push_back(std::uint8_t(touched));
        for (int branch = 0; branch < 8; ++branch) counts[branch] += touched >> branch & 1;
    }
    const int undivided = int(std::ranges::count(counts, count));
    const int if_undivided = undivided > 1 ? fruitless + 1 : 0;

    std::array<OctreeNode, 8> children;
    for (int branch = 0; branch < 8; ++branch) {
        for (std::size_t i = 0; i < count && counts[branch] > 0; ++i)
            if (octants_[first_octants + i] >> branch & 1)
                members_.push_back(PrimitiveId(members_[begin + i]));
        children[branch] =
            build(cell.octant(branch), begin + count, counts[branch] == count ? if_undivided : 0);
        members_.resize(begin + count);
    }
    octants_.resize(first_octants);
    return tree_.add_inner(children);
}

}  // namespace

Cube mesh_cube(const Box& box) {
    constexpr double margin = 10 * tiny_length;
    constexpr double relative_margin = 1e-12;  // where coordinates are too large for the other one
    Vec3 low, high;
    for (int i = 0; i < 3; ++i) {
        low[i] = box.low[i] - std::max(margin, relative_margin * std::abs(box.low[i]));
        high[i] = box.high[i] + std::max(margin, relative_margin * std::abs(box.high[i]));
    }
    const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    return {0.5 * (high + low - Vec3(size)), size};
}

Octree build_mesh_tree(const MeshTriangles& triangles, const Cube& cube, const MeshLimits& limits,
                       const WarningSink& warn) {
    Octree tree;
    Builder builder(tree, triangles, cube, limits);
    tree.root = builder.build(cube, 0, 0);
    if (builder.largest() > Octree::largest_set)
        warn(std::to_string(builder.largest()) +
             " triangles meet in a cell of the octree that holds 511: RADIANCE's programs will not see all "
             "(a higher -r divides it further)");
    return tree;
}

}  // namespace infra
