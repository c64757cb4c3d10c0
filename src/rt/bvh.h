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

struct Box {
    Vec3 lo{std::numeric_limits<double>::infinity()};
    Vec3 hi{-std::numeric_limits<double>::infinity()};

    void extend(const Vec3& p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void extend(const Box& b) {
        extend(b.lo);
        extend(b.hi);
    }
    bool empty() const { return lo.x > hi.x; }
};

class Bvh {
  public:
    /// What the hierarchy is built of: a number that walk() hands back, and its box rounded outward.
    struct Item {
        Item(const Box& box, std::uint32_t id);
        std::uint32_t id() const { return std::bit_cast<std::uint32_t>(lo[3]); }

        float lo[4];  ///< the fourth holds the number's bits
        float hi[4];
    };

    void build(std::vector<Item> items);

    /// The items' numbers in the order of the leaves, with ~0u after each leaf. Numbers may be exchanged for
    /// others of the same things; ~0u is no number.
    std::vector<std::uint32_t>& items() { return items_; }

    /// Calls visit(item) for every item whose box the ray may meet nearer than limit(), near boxes first.
    /// visit returns true to end the walk. limit() is asked again after every visit.
    template <class Visit, class Limit>
    void walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const;

    std::size_t memory_bytes() const {
        return nodes_.size() * sizeof(Node) + items_.size() * sizeof(items_[0]);
    }

  private:
    typedef float Float4 __attribute__((vector_size(16)));
    typedef std::int32_t Int4 __attribute__((vector_size(16)));

    struct alignas(16) Node {
        Float4 plane[2][3];  // [low or high side][axis], a lane for each child
        std::int32_t
            child[4];  // index of a node, or the complement of a leaf's first item; an empty box: none
    };

    static constexpr std::uint32_t end_of_leaf = ~0u;
    static constexpr int stack_size = 256;

    struct Builder;

    static int mask_bits(Int4 mask) {
#if defined(__SSE__)
        return __builtin_ia32_movmskps(reinterpret_cast<Float4>(mask));
#else
        return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
#endif
    }

    bool near_box(const Vec3& p) const {
        return p.x >= near_lo_.x && p.y >= near_lo_.y && p.z >= near_lo_.z && p.x <= near_hi_.x &&
               p.y <= near_hi_.y && p.z <= near_hi_.z;
    }
    /// Distance at which a ray enters the box; false if it misses it or the limit comes first.
    bool advance_to_box(const Vec3& origin, const Vec3& direction, double limit, double& enter) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    Box box_;
    Vec3 near_lo_{0}, near_hi_{0};  ///< the box and as much again on all sides
};

template <class Visit, class Limit>
void Bvh::walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const {
    if (nodes_.empty()) return;

    // Single precision serves from the box's neighbourhood on: move there from farther away.
    double enter = 0;
    if (!near_box(origin) && !advance_to_box(origin, direction, limit(), enter)) return;

    const auto component = [](double d) {
        return static_cast<float>(std::fabs(d) < 1e-30 ? std::copysign(1e-30, d) : d);
    };
    const Float4 d{component(direction.x), component(direction.y), component(direction.z), 1.0f};
    const Float4 inverse = 1.0f / d;
    Float4 start[3], slope[3];
    int near_side[3];
    for (int axis = 0; axis < 3; ++axis) {
        const float o = static_cast<float>(origin[axis] + direction[axis] * enter);
        const float i = inverse[axis];
        start[axis] = Float4{o, o, o, o};
        slope[axis] = Float4{i, i, i, i};
        near_side[axis] = i < 0;
    }

    constexpr float outward = 1.0f + 6e-7f;  // rounding of the far distances, four operations
    // Nodes to visit and where the ray enters them, in two arrays so that no load spans two stores.
    std::int32_t stack[stack_size];
    float entry[stack_size];
    int depth = 1;
    stack[0] = 0;
    entry[0] = 0.0f;
    float far = static_cast<float>(limit() - enter) * outward;

    while (depth > 0) {
        const std::int32_t place = stack[--depth];
        if (entry[depth] > far) continue;
        if (place < 0) {
            for (const std::uint32_t* item = &items_[static_cast<std::size_t>(~place)]; *item != end_of_leaf;
                 ++item)
                if (visit(*item)) return;
            far = static_cast<float>(limit() - enter) * outward;
            continue;
        }
        const Node& node = nodes_[static_cast<std::size_t>(place)];
        Float4 t_near = Float4{0, 0, 0, 0};
        Float4 t_far = Float4{far, far, far, far};
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 t0 = (node.plane[near_side[axis]][axis] - start[axis]) * slope[axis];
            const Float4 t1 = (node.plane[1 - near_side[axis]][axis] - start[axis]) * slope[axis] * outward;
            t_near = t0 > t_near ? t0 : t_near;
            t_far = t1 < t_far ? t1 : t_far;
        }
        const int first = depth;
        for (int hits = mask_bits(t_near <= t_far); hits; hits &= hits - 1) {
            const int lane = __builtin_ctz(static_cast<unsigned>(hits));
            const float t = t_near[lane];
            int i = depth++;  // keep the nearest on top
            for (; i > first && entry[i - 1] < t; --i) {
                entry[i] = entry[i - 1];
                stack[i] = stack[i - 1];
            }
            entry[i] = t;
            stack[i] = node.child[lane];
        }
    }
}

}  // namespace infra
