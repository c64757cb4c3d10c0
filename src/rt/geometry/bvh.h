// Bounding volume hierarchy over the shapes of a scene: four children a node, boxes in single precision
// rounded outward, built by the surface area heuristic.
//
// A ray is first moved to where it enters the scene's box, so that single precision is relative to the
// scene's size however far away the viewer stands; the shapes themselves are tested in double precision from
// the true origin. source: Wald, Benthin & Boulos, "Getting Rid of Packets" (2008), for the four-wide layout;
// Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007), for the binned build.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "common/vec.h"

namespace infra {

struct Bounds {
    Vec3 lo{std::numeric_limits<double>::infinity()};
    Vec3 hi{-std::numeric_limits<double>::infinity()};

    void extend(const Vec3& p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void extend(const Bounds& b) {
        extend(b.lo);
        extend(b.hi);
    }
    bool empty() const { return lo.x > hi.x; }
};

class Bvh {
  public:
    /// What the hierarchy is built of: a number that walk() hands back, and its box rounded outward.
    struct Item {
        Item(const Bounds& box, std::uint32_t id);
        std::uint32_t id() const { return std::bit_cast<std::uint32_t>(lo[3]); }

        float lo[4];  ///< the fourth holds the number's bits
        float hi[4];
    };

    void build(std::vector<Item> items);

    /// Around all items; empty if there are none.
    const Bounds& bounds() const { return box_; }

    static constexpr std::uint32_t end_of_leaf = ~0u;

    /// The items' numbers in the order of the leaves, with end_of_leaf after each leaf. Numbers may be
    /// exchanged for others of the same things; end_of_leaf is no number.
    std::vector<std::uint32_t>& items() { return items_; }

    /// Calls visit(item) for every item whose box the ray may meet nearer than limit(), near boxes first.
    /// visit returns true to end the walk. limit() is asked again after every visit.
    template <class Visit, class Limit>
    void walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const;

  private:
    typedef float Float4 __attribute__((vector_size(16)));
    typedef std::int32_t Int4 __attribute__((vector_size(16)));

    struct alignas(16) Node {
        Float4 plane[2][3];  // [low or high side][axis], a lane for each child
        std::int32_t
            child[4];  // index of a node, or the complement of a leaf's first item; an empty box: none
    };

    static constexpr int stack_size = 256;

    struct Builder;
    static int mask_bits(Int4 mask);

    bool near_box(const Vec3& p) const {
        return p.x >= near_lo_.x && p.y >= near_lo_.y && p.z >= near_lo_.z && p.x <= near_hi_.x &&
               p.y <= near_hi_.y && p.z <= near_hi_.z;
    }
    /// Distance at which a ray enters the box; false if it misses it or the limit comes first.
    bool advance_to_box(const Vec3& origin, const Vec3& direction, double limit, double& enter) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    Bounds box_;
    Vec3 near_lo_{0}, near_hi_{0};  ///< the box and as much again on all sides
};

}  // namespace infra
