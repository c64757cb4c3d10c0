// The octree of .oct files: cells that are empty, hold a set of primitives, or have 8 children.
// Our ray tracer builds its own hierarchy; this one is for RADIANCE's programs and for `oconv -i`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/vec.h"
#include "scene/scene.h"

namespace infra {

/// Axis-parallel cube, scene units. Size 0: nothing in it.
struct Cube {
    Vec3 origin{0, 0, 0};
    double size = 0;

    /// Eighth number `branch`: bit 0 set is the upper half in x, bit 1 in y, bit 2 in z.
    Cube octant(int branch) const {
        const double half = 0.5 * size;
        return {origin + half * Vec3(branch & 1, branch >> 1 & 1, branch >> 2 & 1), half};
    }
    /// Corner number `i`, numbered as octants.
    Vec3 corner(int i) const { return origin + size * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1); }
    Vec3 center() const { return origin + Vec3(0.5 * size); }
};

/// A cell: empty_node, a leaf's set, or an inner cell.
using OctreeNode = std::int32_t;
inline constexpr OctreeNode empty_node = -1;

class Octree {
  public:
    /// Largest set of a leaf that RADIANCE's programs read.
    static constexpr std::size_t largest_set = 511;

    OctreeNode root = empty_node;

    static bool is_inner(OctreeNode node) { return node >= 0; }
    static bool is_leaf(OctreeNode node) { return node < empty_node; }

    OctreeNode child(OctreeNode inner, int branch) const {
        return children_[8 * std::size_t(inner) + branch];
    }
    /// Inner cell with these 8 children; if all are empty or leaves of equal sets, the first of them instead.
    OctreeNode add_inner(std::span<const OctreeNode, 8> children);
    /// Leaf for an ascending set of primitives, often one that was made lately if their sets are equal:
    /// surfaces larger than cells lie in many neighbours. The empty one is empty_node.
    OctreeNode add_leaf(std::span<const PrimitiveId> set);
    /// Valid until the next add_leaf().
    std::span<const PrimitiveId> set(OctreeNode leaf) const;

  private:
    bool same_leaf(OctreeNode a, OctreeNode b) const;
    std::vector<OctreeNode> children_;         // 8 by 8
    std::vector<PrimitiveId> members_;         // of all sets, one after another
    std::vector<std::uint32_t> set_begin_{0};  // set i is members_[set_begin_[i] .. set_begin_[i + 1])
    struct Remembered {
        std::uint64_t hash = 0;
        OctreeNode leaf = empty_node;
    };
    std::vector<Remembered> lately_;  // leaves by the hash of their sets
};

}  // namespace infra
