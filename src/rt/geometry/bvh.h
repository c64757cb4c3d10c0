// Bounding volume hierarchy over the shapes of a scene, built by the surface area heuristic: eight children a
// node, their boxes in bytes.
//
// A node of 96 bytes keeps its children's boxes as multiples of a power of two from a corner of its own. A
// leaf is up to eight shapes of one sort, triangles or others. Shapes are numbered by leaf; that number, the
// slot, is all that a node says of a leaf. The corners of a leaf's triangles are kept like boxes, in the 32
// bytes a shape that its item took for the build. The walk of a ray (bvh_kernel.h) tests eight boxes or eight
// triangles at once in single precision, and hands over the shapes that the ray may meet; those are tested in
// double precision by whoever asked. All that is rounded, is rounded so that nothing is lost: boxes outward,
// the sides of triangles by a bound of the error (bvh_kernel.h). So a hit never depends on what the hierarchy
// is made of.
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
#include <limits>
#include <span>
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

    float origin[3];
    std::uint8_t exponent[3];
    std::uint8_t count;               ///< children, the first lanes; never 0
    std::uint8_t plane[2][3][width];  ///< [low or high side][axis]
    std::uint32_t child[width];       ///< index of a node, or a leaf's BvhLeaf::reference
};

/// Triangles of a leaf. Coordinate q of a corner lies at origin[axis] + q 2^(exponent - 127).
struct BvhLeaf {
    static constexpr std::size_t largest = 8;  ///< shapes
    static constexpr std::uint32_t flag = 1u << 31;
    static constexpr int slot_bits = 28;
    static constexpr std::uint32_t most_slots = 1u << slot_bits;

    float origin[3];
    std::uint16_t exponent;
    std::uint16_t rows[9 * largest];  ///< [axis][corner], as many numbers as there are triangles

    static std::uint32_t reference(std::size_t slot, std::size_t count) {
        return static_cast<std::uint32_t>(flag | (count - 1) << slot_bits | slot);
    }
    static std::uint32_t slot(std::uint32_t reference) { return reference & (most_slots - 1); }
    static std::uint32_t count(std::uint32_t reference) { return (reference >> slot_bits & 7) + 1; }
    /// Bytes in use, which are no more than those of the items were.
    static constexpr std::size_t size(std::size_t triangles) { return 14 + 18 * triangles; }
};

struct BvhRay;

/// The walk as it is compiled for a processor: bvh_kernel.h.
using BvhKernel = void (*)(BvhRay& ray);
BvhKernel portable_bvh_kernel();
BvhKernel best_bvh_kernel();  ///< for the processor at hand

class Bvh {
  public:
    /// What the hierarchy is built of: a number that walk() hands back, and its box rounded outward.
    struct Item {
        Item() = default;
        Item(const Bounds& box, std::uint32_t id, std::uint32_t note = 0);
        std::uint32_t id() const { return std::bit_cast<std::uint32_t>(lo[3]); }
        /// For whoever made the item.
        std::uint32_t note() const { return std::bit_cast<std::uint32_t>(hi[3]); }

        float lo[4];  ///< the fourth holds the number's bits
        float hi[4];
    };

    /// Whose triangles the leaves hold. It is told in which slots they come to lie.
    class LeafTriangles {
      public:
        virtual ~LeafTriangles() = default;
        /// The triangles of these items will be placed soon: asks for their memory.
        virtual void announce(std::span<const Item> items) const = 0;
        /// Takes note that the triangles of these items have the slots from `first` on.
        ///   corners  is told theirs
        ///   returns  how far at most one of them can be met from what is between its corners
        virtual double place(std::span<const Item> items, std::size_t first,
                             std::array<Vec3, 3>* corners) = 0;
    };

    /// walk() will call the triangles by their slots. Other items keep their numbers, which must not be below
    /// that of triangles.
    ///   throws  Error if there are more than 2^28 shapes
    void build(LargeVector<Item> triangle_items, const std::vector<Item>& other_items,
               LeafTriangles& triangles);
    /// Where what is known of each slot's triangle stands in memory, `size` bytes each, to be asked for in
    /// advance.
    void set_records(const void* first, std::size_t size) {
        records_ = static_cast<const std::uint8_t*>(first);
        record_size_ = static_cast<std::uint32_t>(size);
    }

    /// Around all items; empty if there are none.
    const Bounds& bounds() const { return box_; }

    /// For tests; both kernels hand over all that a ray may meet.
    void use(BvhKernel kernel) { kernel_ = kernel; }

    /// Calls visit(item) for every item that the ray may meet nearer than limit(), near boxes first. visit
    /// returns true to end the walk. limit() is asked again after every leaf.
    template <class Visit, class Limit>
    void walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const;

  private:
    struct Builder;
    bool near_box(const Vec3& p) const {
        return p.x >= near_lo_.x && p.y >= near_lo_.y && p.z >= near_lo_.z && p.x <= near_hi_.x &&
               p.y <= near_hi_.y && p.z <= near_hi_.z;
    }
    /// Distance at which a ray enters the box; false if it misses it or the limit comes first.
    bool advance_to_box(const Vec3& origin, const Vec3& direction, double limit, double& enter) const;

    LargeVector<BvhNode> nodes_;
    LargeVector<Item> leaves_;           ///< by slot; once built, what BvhLeaf says
    std::vector<std::uint32_t> others_;  ///< numbers of the items in the slots behind the triangles'
    std::uint32_t triangle_count_ = 0;
    const std::uint8_t* records_ = nullptr;
    std::uint32_t record_size_ = 0;
    BvhKernel kernel_ = best_bvh_kernel();
    float reach_ = 0;  ///< no coordinate of a shape, or of a ray that has entered, is larger
    Bounds box_;
    Vec3 near_lo_{0}, near_hi_{0};  ///< the box and as much again on all sides
};

}  // namespace infra
