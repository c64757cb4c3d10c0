// Bounding volume hierarchy over the shapes of a scene, built by the surface area heuristic: eight children a
// node, their boxes in bytes.
//
// A node of 96 bytes keeps its children's boxes as multiples of a power of two from a corner of its own, a
// leaf up to eight shapes and, in the same way, the corners of those that are triangles. The walk of a ray
// (bvh_kernel.h) tests eight boxes or eight triangles at once in single precision, and hands over the shapes
// that the ray may meet; those are tested in double precision by whoever asked. All that is rounded, is
// rounded so that nothing is lost: boxes outward, the sides of triangles by a bound of the error
// (bvh_kernel.h). So a hit never depends on what the hierarchy is made of.
//
// A ray is first moved to where it enters the scene's box, so that single precision is relative to the
// scene's size however far away the viewer stands.
// source: Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs"
// (2017), for boxes in bytes; Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007),
// for the binned build.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "common/large_pages.h"
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

/// Eight children. Plane q of an axis lies at origin[axis] + q 2^(exponent[axis] - 127).
struct BvhNode {
    static constexpr int width = 8;
    static constexpr std::uint32_t leaf_bit = 1u << 31;

    float origin[3];
    std::uint8_t exponent[3];
    std::uint8_t count;               ///< children, the first lanes; never 0
    std::uint8_t plane[2][3][width];  ///< [low or high side][axis]
    std::uint32_t child[width];       ///< index of a node, or leaf_bit and where a leaf begins
};

/// What a leaf begins with. Behind it stand the shapes' numbers, 4 bytes each, then the coordinates of
/// those that are triangles, 2 bytes each: rows of as many as there are triangles, by [axis][corner].
/// Other shapes stand before the triangles.
struct BvhLeaf {
    static constexpr std::size_t largest = 8;    ///< shapes
    static constexpr std::size_t alignment = 8;  ///< bytes; what BvhNode::child counts

    float origin[3];
    std::uint8_t exponent[3];
    std::uint8_t triangles : 4, others : 4;

    unsigned count() const { return others + triangles; }
    std::uint32_t* items() { return reinterpret_cast<std::uint32_t*>(this + 1); }
    const std::uint32_t* items() const { return reinterpret_cast<const std::uint32_t*>(this + 1); }
    std::uint16_t* rows() { return reinterpret_cast<std::uint16_t*>(items() + count()); }
    const std::uint16_t* rows() const { return reinterpret_cast<const std::uint16_t*>(items() + count()); }
};

struct BvhRay;

/// The walk as it is compiled for a processor: near boxes first, or in any order.
struct BvhKernel {
    void (*nearest_first)(BvhRay& ray);
    void (*any)(BvhRay& ray);

    static BvhKernel portable();
    static BvhKernel best();  ///< for the processor at hand
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

    /// Corners of what is a triangle, and cannot be met but between them. False for other shapes.
    using Corners = std::function<bool(std::uint32_t id, std::array<Vec3, 3>& corners)>;

    void build(std::vector<Item> items, const Corners& corners);

    /// Around all items; empty if there are none.
    const Bounds& bounds() const { return box_; }

    /// Calls visit(number) for all numbers, in the order of the leaves; it may be exchanged for another of
    /// the same thing.
    template <class Visit>
    void for_each_item(Visit&& visit) {
        for (std::size_t at = 0; at + 2 < leaves_.size();) {
            auto& leaf = *reinterpret_cast<BvhLeaf*>(&leaves_[at]);
            for (unsigned i = 0; i < leaf.count(); ++i) visit(leaf.items()[i]);
            at += leaf_units(leaf.others, leaf.triangles);
        }
    }

    enum class Order { nearest_first, any };

    /// Calls visit(item) for every item that the ray may meet nearer than limit(); with Order::nearest_first
    /// near boxes first. visit returns true to end the walk. limit() is asked again after every visit.
    template <Order order, class Visit, class Limit>
    void walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const;

  private:
    struct Builder;
    struct alignas(BvhLeaf::alignment) Unit {
        std::uint8_t bytes[BvhLeaf::alignment];
    };

    static std::size_t leaf_units(unsigned others, unsigned triangles);

    bool near_box(const Vec3& p) const {
        return p.x >= near_lo_.x && p.y >= near_lo_.y && p.z >= near_lo_.z && p.x <= near_hi_.x &&
               p.y <= near_hi_.y && p.z <= near_hi_.z;
    }
    /// Distance at which a ray enters the box; false if it misses it or the limit comes first.
    bool advance_to_box(const Vec3& origin, const Vec3& direction, double limit, double& enter) const;

    LargeVector<BvhNode> nodes_;
    LargeVector<Unit> leaves_;
    BvhKernel kernel_ = BvhKernel::best();
    float reach_ = 0;  ///< no coordinate of a shape, or of a ray that has entered, is larger
    Bounds box_;
    Vec3 near_lo_{0}, near_hi_{0};  ///< the box and as much again on all sides
};

}  // namespace infra
