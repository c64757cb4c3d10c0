#include "scene/octree_build.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/cell_overlap.h"
#include "scene/surface_geometry.h"

namespace infra {
namespace {

/// Surfaces that after this many divisions all still share one cell (coincident ones, or those round a vertex
/// of a mesh) are left in it: dividing down to the resolution would only multiply cells.
constexpr int most_fruitless_divisions = 6;

/// No coordinate may be larger: their products must stay within double. RADIANCE sees nothing beyond 1e10.
constexpr double largest_coordinate = 1e15;

class Builder {
  public:
    Builder(Octree& tree, const Cube& cube, const Scene& scene, InstanceBoxes& instances,
            const OctreeLimits& limits, const WarningSink& warn)
        : tree_(tree),
          scene_(scene),
          most_(static_cast<std::size_t>(limits.objects)),
          smallest_(cube.size / limits.resolution * (1 - 1e-6)),
          overlap_(scene, instances, smallest_),
          warn_(warn) {}

    /// Node for `cell`, which holds `old`, with `added` (ascending, after all old ones) put in where they
    /// touch it.
    OctreeNode insert(OctreeNode old, const Cube& cell, std::span<const PrimitiveId> added) {
        for (const PrimitiveId id : added) push_if_touching({id, false}, cell);
        return build(old, cell, 0, 0);
    }

  private:
    struct Member {
        PrimitiveId id;
        bool contained;  ///< the cell lies inside this volume: dividing the cell changes nothing for it
    };

    void push_if_touching(Member member, const Cube& cell) {
        if (!member.contained) {
            const Overlap overlap = overlap_(member.id, cell);
            if (overlap == Overlap::none) return;
            member.contained = overlap == Overlap::contained;
        }
        members_.push_back(member);
    }

    OctreeNode build(OctreeNode old, const Cube& cell, std::size_t begin, int fruitless);
    OctreeNode divide(OctreeNode old, const Cube& cell, std::size_t begin, int fruitless);
    OctreeNode make_leaf(std::size_t begin);

    Octree& tree_;
    const Scene& scene_;
    std::size_t most_;
    double smallest_;
    CellOverlap overlap_;
    const WarningSink& warn_;
    std::vector<Member> members_;  // of the cells on the way from the root, the current one's last
    std::vector<PrimitiveId> set_;
    bool warned_ = false;
};

/// The new members of the cell are members_[begin..]; `fruitless` divisions have not made them fewer.
OctreeNode Builder::build(OctreeNode old, const Cube& cell, std::size_t begin, int fruitless) {
    if (members_.size() == begin) return old;
    if (Octree::is_inner(old)) return divide(old, cell, begin, fruitless);
    if (Octree::is_leaf(old)) {
        const auto added = std::vector<Member>(members_.begin() + std::ptrdiff_t(begin), members_.end());
        members_.resize(begin);
        for (const PrimitiveId id : tree_.set(old)) {
            const bool volume = scene_.type_info(id).kind == PrimitiveKind::volume;
            members_.push_back({id, volume && overlap_(id, cell) == Overlap::contained});
        }
        members_.insert(members_.end(), added.begin(), added.end());
    }
    const auto divisible = std::count_if(members_.begin() + std::ptrdiff_t(begin), members_.end(),
                                         [](const Member& m) { return !m.contained; });
    if (std::size_t(divisible) <= most_ || 0.5 * cell.size < smallest_ ||
        fruitless >= most_fruitless_divisions)
        return make_leaf(begin);
    return divide(empty_node, cell, begin, fruitless);
}

OctreeNode Builder::divide(OctreeNode old, const Cube& cell, std::size_t begin, int fruitless) {
    const std::size_t end = members_.size();
    std::array<OctreeNode, 8> children;
    for (int branch = 0; branch < 8; ++branch) {
        const Cube octant = cell.octant(branch);
        for (std::size_t i = begin; i < end; ++i) push_if_touching(Member(members_[i]), octant);
        const OctreeNode before = Octree::is_inner(old) ? tree_.child(old, branch) : empty_node;
        const bool fewer = members_.size() - end < end - begin;
        children[branch] = build(before, octant, end, fewer ? 0 : fruitless + 1);
        members_.resize(end);
    }
    return tree_.add_inner(children);
}

OctreeNode Builder::make_leaf(std::size_t begin) {
    set_.clear();
    for (std::size_t i = begin; i < members_.size(); ++i) set_.push_back(members_[i].id);
    if (set_.size() > Octree::largest_set) {
        const PrimitiveId lost = set_[Octree::largest_set];
        const std::string what =
            "left out of a cell that holds " + std::to_string(Octree::largest_set) + " surfaces already";
        if (!std::exchange(warned_, true)) warn_(scene_.error(lost, what, "others may be too").what());
        set_.resize(Octree::largest_set);
    }
    return tree_.add_leaf(set_);
}

}  // namespace

Cube bounding_cube(const Scene& scene, PrimitiveId first) {
    InstanceBoxes instances(scene);
    Box box;
    for (PrimitiveId id = first; id < scene.size(); ++id) {
        if (!scene.type_info(id).is_geometry()) continue;
        check_arguments(scene, id);
        box.add(surface_box(scene, id, instances));
    }
    if (box.empty()) return {};
    const Vec3 extent = box.high - box.low;
    const double size = std::max({extent.x, extent.y, extent.z}) + 2 * cube_margin;
    return {0.5 * (box.low + box.high - Vec3(size)), size};
}

void add_to_octree(Octree& tree, const Cube& cube, const Scene& scene, PrimitiveId first,
                   const OctreeLimits& limits, const WarningSink& warn) {
    InstanceBoxes instances(scene);
    const Vec3 low = cube.origin, high = low + Vec3(cube.size);
    std::vector<PrimitiveId> added;
    for (PrimitiveId id = first; id < scene.size(); ++id) {
        if (!scene.type_info(id).is_geometry()) continue;
        const SurfaceCheck check = check_surface(scene, id);
        if (!check.remark.empty()) warn(scene.error(id, check.remark).what());
        const Box box = surface_box(scene, id, instances);
        if (box.empty()) continue;
        const double farthest =
            std::max({-box.low.x, -box.low.y, -box.low.z, box.high.x, box.high.y, box.high.z});
        if (farthest > largest_coordinate) throw scene.error(id, "a coordinate beyond 1e15");
        const bool sticks_out = box.low.x < low.x || box.low.y < low.y || box.low.z < low.z ||
                                box.high.x > high.x || box.high.y > high.y || box.high.z > high.z;
        if (sticks_out) throw scene.error(id, "sticks out of the octree's cube");
        if (check.usable) added.push_back(id);
    }
    Builder builder(tree, cube, scene, instances, limits, warn);
    tree.root = builder.insert(tree.root, cube, added);
}

}  // namespace infra
