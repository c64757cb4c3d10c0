#include "scene/octree_build.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "scene/cell_overlap.h"
#include "scene/surface_geometry.h"

namespace infra {
namespace {

/// Surfaces that divisions do not part, because they coincide or meet in an edge, are divided down to the
/// resolution as in RADIANCE: byte for byte the same tree. But not without end: when that has taken so many
/// tests for overlap with the octants of a cell, further cells are left as they are after a few divisions.
constexpr int most_fruitless_divisions = 6;
constexpr std::size_t most_fruitless_tests = 1 << 23;

/// Smallest cell that is ever divided, scene units: within the tolerances of the tests for overlap, where
/// dividing parts nothing. RADIANCE does not stop there in scenes smaller than 2 cm and its default
/// resolution.
constexpr double smallest_divided = 1e-7;

/// No coordinate may be larger: their products must stay within double. RADIANCE sees nothing beyond 1e10.
constexpr double largest_coordinate = 1e15;

class Builder {
  public:
    Builder(Octree& tree, const Cube& cube, const Scene& scene, InstanceBoxes& instances,
            const OctreeLimits& limits, const WarningSink& warn)
        : tree_(tree),
          scene_(scene),
          most_(static_cast<std::size_t>(limits.objects)),
          smallest_(std::max(cube.size / limits.resolution - tiny_length, smallest_divided)),
          overlap_(scene, instances, smallest_),
          warn_(warn) {}

    /// Node for `cell`, which holds `old`, with `added` (ascending, after all old ones) put in where they
    /// touch it.
    OctreeNode insert(OctreeNode old, const Cube& cell, std::span<const PrimitiveId> added) {
        const Cube twice{cell.origin, 2 * cell.size};  // the cell is its first octant
        const OctantOverlap polygons(twice);
        for (const PrimitiveId id : added) {
            const Overlap overlap = overlap_.octants(id, twice, polygons)[0];
            if (overlap == Overlap::none) continue;
            members_.push_back({id, overlap == Overlap::contained});
            volumes_ = volumes_ || is_volume(id);
        }
        return build(old, cell, {0, members_.size()}, 0);
    }

  private:
    /// A surface or volume that touches a cell. A cell's members stand in the order in which they come to it:
    /// that decides whether it is divided, as volumes that contain it do not ask for that.
    struct Member {
        PrimitiveId id;
        bool contained;  ///< the cell lies inside this volume
    };
    /// A cell's members: members_[begin..end - 1].
    struct Range {
        std::size_t begin, end;
        std::size_t count() const { return end - begin; }
    };

    bool is_volume(PrimitiveId id) const { return scene_.type_info(id).kind == PrimitiveKind::volume; }

    OctreeNode build(OctreeNode old, const Cube& cell, Range added, int fruitless);
    OctreeNode divide(OctreeNode old, const Cube& cell, Range added, int fruitless);
    std::array<Range, 8> sort_into_octants(const Cube& cell, Range members);
    Range put_before(OctreeNode leaf, const Cube& cell, Range added);
    bool may_divide(const Cube& cell, int fruitless) const;
    std::size_t dividing_member(Range& members, std::size_t known, bool divisible);
    void order_for_octants(std::size_t begin, std::size_t dividing);
    OctreeNode make_leaf(Range members);

    Octree& tree_;
    const Scene& scene_;
    std::size_t most_;
    double smallest_;
    CellOverlap overlap_;
    const WarningSink& warn_;
    std::vector<Member> members_;  // of the cells on the way from the root and their octants, the last's last
    std::vector<OctantBits> octants_;
    std::vector<PrimitiveId> set_;
    bool volumes_ = false;
    bool warned_ = false;
    std::size_t fruitless_tests_ = 0;
};

bool Builder::may_divide(const Cube& cell, int fruitless) const {
    if (0.5 * cell.size < smallest_) return false;
    return fruitless < most_fruitless_divisions || fruitless_tests_ < most_fruitless_tests;
}

/// What a leaf holds, then those that are new, as the last of members_.
Builder::Range Builder::put_before(OctreeNode leaf, const Cube& cell, Range added) {
    const std::size_t begin = members_.size();
    for (const PrimitiveId id : tree_.set(leaf)) {
        members_.push_back({id, is_volume(id) && overlap_(id, cell) == Overlap::contained});
        volumes_ = volumes_ || is_volume(id);
    }
    for (std::size_t i = added.begin; i < added.end; ++i) members_.push_back(Member(members_[i]));
    return {begin, members_.size()};
}

/// The first member that finds the cell full, where the first `known` are there already; members.end if none
/// does. Members for which there is no room are dropped.
std::size_t Builder::dividing_member(Range& members, std::size_t known, bool divisible) {
    std::size_t i = members.begin + known;
    while (i < members.end) {
        const std::size_t held = i - members.begin;
        const bool full = held > 0 && held >= most_ && divisible && !members_[i].contained;
        if (full) return i;
        if (held < Octree::largest_set) {
            ++i;
            continue;
        }
        const std::string what =
            "left out of a cell that holds " + std::to_string(Octree::largest_set) + " surfaces already";
        if (!std::exchange(warned_, true))
            warn_(scene_.error(members_[i].id, what, "others may be too").what());
        std::copy(members_.begin() + std::ptrdiff_t(i) + 1, members_.begin() + std::ptrdiff_t(members.end),
                  members_.begin() + std::ptrdiff_t(i));
        --members.end;
    }
    return i;
}

/// What a divided cell hands on: the surfaces that it held and the one that divided it, the volumes that
/// reach into it, those that contain it; then those that come after.
void Builder::order_for_octants(std::size_t begin, std::size_t dividing) {
    if (!volumes_) return;
    const PrimitiveId divider = members_[dividing].id;
    const auto key = [&](const Member& m) {
        const int rank = m.id == divider ? 1 : !is_volume(m.id) ? 0 : m.contained ? 3 : 2;
        return std::pair(rank, m.id);
    };
    std::sort(members_.begin() + std::ptrdiff_t(begin), members_.begin() + std::ptrdiff_t(dividing) + 1,
              [&](const Member& a, const Member& b) { return key(a) < key(b); });
}

/// `added` are new to the cell; `fruitless` divisions have not made them fewer.
OctreeNode Builder::build(OctreeNode old, const Cube& cell, Range added, int fruitless) {
    if (added.count() == 0) return old;
    if (Octree::is_inner(old)) return divide(old, cell, added, fruitless);
    const std::size_t before = members_.size();
    std::size_t known = 0;
    if (Octree::is_leaf(old)) {
        known = tree_.set(old).size();
        added = put_before(old, cell, added);
    }
    const std::size_t dividing = dividing_member(added, known, may_divide(cell, fruitless));
    OctreeNode node;
    if (dividing == added.end) {
        node = make_leaf(added);
    } else {
        order_for_octants(added.begin, dividing);
        node = divide(empty_node, cell, added, fruitless);
    }
    members_.resize(before);
    return node;
}

/// Puts the members of a cell's octants, which are told in this order, behind all others.
std::array<Builder::Range, 8> Builder::sort_into_octants(const Cube& cell, Range members) {
    octants_.clear();
    const OctantOverlap polygons(cell);
    std::array<std::size_t, 8> counts{};
    for (std::size_t i = members.begin; i < members.end; ++i) {
        const PrimitiveId id = members_[i].id;
        const Vec3* const triangle = overlap_.triangle(id);
        const OctantBits bits = triangle ? OctantBits{polygons(std::span<const Vec3, 3>(triangle, 3))}
                                         : overlap_.octants(id, cell, polygons);
        octants_.push_back(bits);
        for (int branch = 0; branch < 8; ++branch) counts[branch] += bits.touched >> branch & 1;
    }
    std::array<Range, 8> octants;
    std::size_t end = members_.size();
    for (int branch = 0; branch < 8; ++branch) {
        octants[branch] = {end, end};
        end += counts[branch];
    }
    members_.resize(end);
    for (std::size_t i = 0; i < members.count(); ++i) {
        Member member = members_[members.begin + i];
        for (unsigned left = octants_[i].touched; left != 0; left &= left - 1) {
            const int branch = std::countr_zero(left);
            member.contained = octants_[i].contained >> branch & 1;
            members_[octants[branch].end++] = member;
        }
    }
    return octants;
}

OctreeNode Builder::divide(OctreeNode old, const Cube& cell, Range added, int fruitless) {
    if (fruitless >= most_fruitless_divisions) fruitless_tests_ += added.count();
    const std::size_t before = members_.size();
    const std::array<Range, 8> octants = sort_into_octants(cell, added);
    const auto undivided = [&](const Range& octant) { return octant.count() == added.count(); };
    const int if_undivided = std::ranges::count_if(octants, undivided) > 1 ? fruitless + 1 : 0;
    std::array<OctreeNode, 8> children;
    for (int branch = 0; branch < 8; ++branch) {
        const OctreeNode known = Octree::is_inner(old) ? tree_.child(old, branch) : empty_node;
        children[branch] =
            build(known, cell.octant(branch), octants[branch], undivided(octants[branch]) ? if_undivided : 0);
    }
    members_.resize(before);
    return tree_.add_inner(children);
}

OctreeNode Builder::make_leaf(Range members) {
    set_.clear();
    for (std::size_t i = members.begin; i < members.end; ++i) set_.push_back(members_[i].id);
    if (volumes_) std::ranges::sort(set_);
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
    const Vec3 low = box.low - cube_margin, high = box.high + cube_margin;
    const Vec3 extent = high - low;
    const double size = std::max({extent.x, extent.y, extent.z});
    return {(high + low - size) * 0.5, size};
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
