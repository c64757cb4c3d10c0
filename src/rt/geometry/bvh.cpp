#include "rt/geometry/bvh.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "common/error.h"

namespace infra {
namespace {

constexpr int most_bins = 16;
constexpr std::size_t triangles_a_leaf = 8;
constexpr std::size_t others_a_leaf = 1;  // no cheap test goes before theirs but that of the box
// From this depth of the binary tree on, ranges are halved, so that it ends before depth 60 and a walk's
// stack is enough: seven entries a level.
constexpr int halving_depth = 32;

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

constexpr float inf = std::numeric_limits<float>::infinity();

/// Three numbers in a register; the fourth lane, which may hold an item's number, becomes 0.
Float4 load(const float* numbers) {
    Int4 bits;
    std::memcpy(&bits, numbers, sizeof bits);
    bits &= Int4{-1, -1, -1, 0};
    return std::bit_cast<Float4>(bits);
}

/// A box in single precision, for building.
struct FloatBox {
    Float4 lo = {inf, inf, inf, inf};
    Float4 hi = {-inf, -inf, -inf, -inf};

    void extend(const FloatBox& other) {
        lo = other.lo < lo ? other.lo : lo;
        hi = other.hi > hi ? other.hi : hi;
    }
    float half_area() const {
        if (lo[0] > hi[0]) return 0;
        const Float4 d = hi - lo;
        return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }
};

FloatBox box_of(const Bvh::Item& item) { return {load(item.lo), load(item.hi)}; }

/// Which of the bins along each axis the centre of an item lies in.
struct Binning {
    Float4 low, scale;

    Binning(const FloatBox& centers, int bins) : low(centers.lo), scale{} {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.hi[axis] - centers.lo[axis];
            if (extent > 0) scale[axis] = static_cast<float>(bins) * (1.0f - 1e-6f) / extent;
        }
    }
    Int4 operator()(const FloatBox& box) const {
        return __builtin_convertvector(((box.lo + box.hi) * 0.5f - low) * scale, Int4);
    }
};

constexpr int least_exponent = -100;  // of steps

/// Steps of a power of two from an origin; so many of them reach from lo to hi, on one axis.
struct Steps {
    float origin;
    int exponent;

    Steps(double lo, double hi, int count) : origin(static_cast<float>(lo)) {
        if (origin > lo) origin = std::nextafter(origin, -inf);
        const double step = (hi - origin) / count;
        exponent = step > 0 ? std::max(std::ilogb(step), least_exponent) : least_exponent;
        if (std::ldexp(static_cast<double>(count), exponent) < hi - origin) ++exponent;
    }
    double in_steps(double x) const { return std::ldexp(x - origin, -exponent); }
    std::uint8_t biased_exponent() const { return static_cast<std::uint8_t>(exponent + 127); }
};

}  // namespace

struct Bvh::Builder {
    struct Range {
        std::size_t begin, end;
        FloatBox box;
        int depth;
        std::size_t size() const { return end - begin; }
    };

    Bvh& bvh;
    LargeVector<Item>& items;
    std::size_t triangle_count;
    const Triangles& triangle;
    double pad;
    std::vector<std::uint32_t> order;  // of the triangles

    bool mixed(const Range& range) const {
        return range.begin < triangle_count && range.end > triangle_count;
    }
    bool is_leaf(const Range& range) const {
        return range.size() <= (range.begin < triangle_count ? triangles_a_leaf : others_a_leaf) &&
               !mixed(range);
    }

    // Splits a range in two by the surface area heuristic; false if it had better stay a leaf.
    bool split(const Range& range, Range& left, Range& right) {
        if (is_leaf(range)) return false;
        left = {range.begin, range.begin, {}, range.depth + 1};
        right = {range.end, range.end, {}, range.depth + 1};
        left.end = right.begin = mixed(range) ? triangle_count : place_to_split(range);
        for (std::size_t i = left.begin; i < left.end; ++i) left.box.extend(box_of(items[i]));
        for (std::size_t i = right.begin; i < right.end; ++i) right.box.extend(box_of(items[i]));
        return true;
    }

    // Sorts a range's items into two parts and returns where the second begins.
    std::size_t place_to_split(const Range& range) {
        if (range.depth >= halving_depth) return range.begin + range.size() / 2;
        FloatBox centers;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const FloatBox b = box_of(items[i]);
            const Float4 center = (b.lo + b.hi) * 0.5f;
            centers.extend({center, center});
        }
        const int bins = range.size() < 64 ? most_bins / 2 : most_bins;
        const Binning bin(centers, bins);
        FloatBox box[3][most_bins];
        std::uint32_t count[3][most_bins] = {};
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const FloatBox b = box_of(items[i]);
            const Int4 place = bin(b);
            for (int axis = 0; axis < 3; ++axis) {
                box[axis][place[axis]].extend(b);
                ++count[axis][place[axis]];
            }
        }
        float best_cost = inf;
        int best_axis = -1, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(bin.scale[axis] > 0)) continue;
            float right_cost[most_bins];
            FloatBox sum;
            std::size_t n = 0;
            for (int b = bins - 1; b > 0; --b) {
                sum.extend(box[axis][b]);
                n += count[axis][b];
                right_cost[b] = sum.half_area() * static_cast<float>(n);
            }
            sum = FloatBox{};
            n = 0;
            for (int b = 0; b < bins - 1; ++b) {
                sum.extend(box[axis][b]);
                n += count[axis][b];
                const float cost = sum.half_area() * static_cast<float>(n) + right_cost[b + 1];
                if (n > 0 && n < range.size() && cost < best_cost) {
                    best_cost = cost;
                    best_axis = axis;
                    best_bin = b;
                }
            }
        }
        if (best_axis < 0) return range.begin + range.size() / 2;  // all centres in one place
        const auto begin = items.begin();
        const auto middle = std::partition(
            begin + static_cast<std::ptrdiff_t>(range.begin), begin + static_cast<std::ptrdiff_t>(range.end),
            [&](const Item& item) { return bin(box_of(item))[best_axis] <= best_bin; });
        return static_cast<std::size_t>(middle - begin);
    }

    // Makes the node of a range; returns its index.
    std::uint32_t make_node(const Range& range) {
        constexpr int width = BvhNode::width;
        Range children[width] = {range};
        bool closed[width] = {};
        int count = 1;
        while (count < width) {  // open the largest child that can be split
            int largest = -1;
            for (int i = 0; i < count; ++i)
                if (!closed[i] &&
                    (largest < 0 || children[i].box.half_area() > children[largest].box.half_area()))
                    largest = i;
            if (largest < 0) break;
            Range left, right;
            if (split(children[largest], left, right)) {
                children[largest] = left;
                children[count++] = right;
            } else {
                closed[largest] = true;
            }
        }
        const std::size_t index = bvh.nodes_.size();
        bvh.nodes_.push_back(packed_boxes(range, children, count));
        for (int i = 0; i < count; ++i) {
            const std::uint32_t child =
                is_leaf(children[i]) ? make_leaf(children[i]) : make_node(children[i]);
            bvh.nodes_[index].child[i] = child;
        }
        return static_cast<std::uint32_t>(index);
    }

    BvhNode packed_boxes(const Range& range, const Range* children, int count) const {
        BvhNode node{};
        node.count = static_cast<std::uint8_t>(count);
        for (int axis = 0; axis < 3; ++axis) {
            const Steps steps(double{range.box.lo[axis]} - pad, double{range.box.hi[axis]} + pad, 255);
            node.origin[axis] = steps.origin;
            node.exponent[axis] = steps.biased_exponent();
            for (int i = 0; i < count; ++i) {
                const double lo = std::floor(steps.in_steps(double{children[i].box.lo[axis]} - pad));
                const double hi = std::ceil(steps.in_steps(double{children[i].box.hi[axis]} + pad));
                node.plane[0][axis][i] = static_cast<std::uint8_t>(lo);
                node.plane[1][axis][i] = static_cast<std::uint8_t>(hi);
            }
        }
        return node;
    }

    // Replaces the items of a range of triangles by what the kernel needs of them.
    std::uint32_t make_leaf(const Range& range) {
        if (range.begin < triangle_count) {
            const std::size_t count = range.size();
            std::array<Vec3, 3> corners[BvhLeaf::largest];
            Bounds box;
            double uncertainty = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const std::uint32_t id = items[range.begin + i].id();
                order[range.begin + i] = id;
                const TriangleExtent extent = triangle(id);
                corners[i] = extent.corners;
                uncertainty = std::max(uncertainty, extent.uncertainty);
                for (const Vec3& corner : corners[i]) box.extend(corner);
            }
            BvhLeaf leaf;
            // The kernel takes a step for what a coordinate may be wrong by.
            int exponent =
                uncertainty > 0 ? std::max(std::ilogb(uncertainty) + 1, least_exponent) : least_exponent;
            for (int axis = 0; axis < 3; ++axis) {
                const Steps steps(box.lo[axis], box.hi[axis], 65535);
                leaf.origin[axis] = steps.origin;
                exponent = std::max(exponent, steps.exponent);
            }
            leaf.exponent = static_cast<std::uint16_t>(exponent + 127);
            std::uint16_t* row = leaf.rows;
            const double steps_per_unit = std::ldexp(1.0, -exponent);
            for (int axis = 0; axis < 3; ++axis)
                for (std::size_t corner = 0; corner < 3; ++corner)
                    for (std::size_t i = 0; i < count; ++i)
                        *row++ = static_cast<std::uint16_t>(
                            (corners[i][corner][axis] - leaf.origin[axis]) * steps_per_unit + 0.5);
            static_assert(BvhLeaf::size(BvhLeaf::largest) <= sizeof leaf && BvhLeaf::size(1) <= sizeof(Item));
            std::memcpy(static_cast<void*>(&items[range.begin]), &leaf, BvhLeaf::size(count));
        } else {
            for (std::size_t i = range.begin; i < range.end; ++i)
                bvh.others_[i - triangle_count] = items[i].id();
        }
        return BvhLeaf::reference(range.begin, range.size());
    }
};

Bvh::Item::Item(const Bounds& box, std::uint32_t id) {
    for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = std::nextafter(static_cast<float>(box.lo[axis]), -inf);
        hi[axis] = std::nextafter(static_cast<float>(box.hi[axis]), inf);
    }
    lo[3] = std::bit_cast<float>(id);
    hi[3] = 0;
}

std::vector<std::uint32_t> Bvh::build(LargeVector<Item> triangle_items, const std::vector<Item>& other_items,
                                      const Triangles& triangle) {
    const std::size_t item_count = triangle_items.size() + other_items.size();
    if (item_count > BvhLeaf::most_slots) throw Error("too many shapes in one octree");
    if (item_count == 0) return {};
    leaves_ = std::move(triangle_items);
    triangle_count_ = static_cast<std::uint32_t>(leaves_.size());
    leaves_.insert(leaves_.end(), other_items.begin(), other_items.end());
    Builder builder{*this, leaves_, triangle_count_, triangle, 0, {}};
    builder.order.resize(triangle_count_);
    others_.resize(other_items.size());
    FloatBox whole;
    for (const Item& item : leaves_) whole.extend(box_of(item));
    double reach = 0;
    Vec3 size;
    for (int axis = 0; axis < 3; ++axis) {
        box_.lo[axis] = whole.lo[axis];
        box_.hi[axis] = whole.hi[axis];
        size[axis] = box_.hi[axis] - box_.lo[axis];
        reach = std::max({reach, std::fabs(box_.lo[axis]), std::fabs(box_.hi[axis])});
    }
    reach += std::max({size.x, size.y, size.z});  // rays start that near
    near_lo_ = box_.lo - size;
    near_hi_ = box_.hi + size;
    // Of boxes: 16 u for what the walk rounds (bvh_kernel.h), and what shapes count as theirs beyond their
    // edges.
    constexpr double u = 0x1p-24, outline = 1.1e-6;
    builder.pad = 16 * u * reach + outline;
    box_.lo -= Vec3(builder.pad);
    box_.hi += Vec3(builder.pad);
    reach_ = static_cast<float>(reach + 2 * builder.pad);

    nodes_.reserve(item_count / 8 + 1);  // more than is needed mostly; what is not touched takes no memory
    builder.make_node({0, item_count, whole, 0});
    leaves_.resize(triangle_count_ + 1);  // the kernel loads 16 bytes where fewer are left
    if (!other_items.empty()) leaves_.shrink_to_fit();
    return std::move(builder.order);
}

bool Bvh::advance_to_box(const Vec3& origin, const Vec3& direction, double limit, double& enter) const {
    double leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < box_.lo[axis] || origin[axis] > box_.hi[axis]) return false;
            continue;
        }
        double t0 = (box_.lo[axis] - origin[axis]) / direction[axis];
        double t1 = (box_.hi[axis] - origin[axis]) / direction[axis];
        if (t0 > t1) std::swap(t0, t1);
        enter = std::max(enter, t0);
        leave = std::min(leave, t1);
    }
    return enter <= leave;
}

}  // namespace infra
