#include "rt/geometry/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace infra {
namespace {

/// Of lanes without a child: no ray that is none of numbers, which meets every box, may go round in circles.
constexpr std::int32_t empty_leaf = ~0;

constexpr int bin_count = 16;
constexpr int leaf_size = 2;
constexpr int deepest = 60;  // of the binary tree; a walk's stack holds three entries a level

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

    explicit Binning(const FloatBox& centers) : low(centers.lo), scale{} {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.hi[axis] - centers.lo[axis];
            if (extent > 0) scale[axis] = bin_count * (1.0f - 1e-6f) / extent;
        }
    }
    Int4 operator()(const FloatBox& box) const {
        return __builtin_convertvector(((box.lo + box.hi) * 0.5f - low) * scale, Int4);
    }
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
    std::vector<Item> items;
    float pad;

    // Splits a range in two by the surface area heuristic; false if it had better stay a leaf.
    bool split(const Range& range, Range& left, Range& right) {
        if (range.size() <= leaf_size || range.depth >= deepest) return false;
        FloatBox centers;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const FloatBox b = box_of(items[i]);
            const Float4 center = (b.lo + b.hi) * 0.5f;
            centers.extend({center, center});
        }
        const Binning bin(centers);
        FloatBox box[3][bin_count];
        std::uint32_t count[3][bin_count] = {};
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
            float right_cost[bin_count];
            FloatBox sum;
            std::size_t n = 0;
            for (int b = bin_count - 1; b > 0; --b) {
                sum.extend(box[axis][b]);
                n += count[axis][b];
                right_cost[b] = sum.half_area() * static_cast<float>(n);
            }
            sum = FloatBox{};
            n = 0;
            for (int b = 0; b < bin_count - 1; ++b) {
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
        left = {range.begin, range.begin, {}, range.depth + 1};
        right = {range.end, range.end, {}, range.depth + 1};
        if (best_axis < 0) {  // all centres in one place
            left.end = right.begin = range.begin + range.size() / 2;
        } else {
            const auto begin = items.begin();
            const auto middle =
                std::partition(begin + static_cast<std::ptrdiff_t>(range.begin),
                               begin + static_cast<std::ptrdiff_t>(range.end),
                               [&](const Item& item) { return bin(box_of(item))[best_axis] <= best_bin; });
            left.end = right.begin = static_cast<std::size_t>(middle - begin);
        }
        for (std::size_t i = left.begin; i < left.end; ++i) left.box.extend(box_of(items[i]));
        for (std::size_t i = right.begin; i < right.end; ++i) right.box.extend(box_of(items[i]));
        return true;
    }

    // Makes the node of a range that has been split at least once; returns its index.
    std::int32_t make_node(const Range& a, const Range& b) {
        Range children[4] = {a, b, {}, {}};
        bool is_leaf[4] = {false, false, false, false};
        int count = 2;
        while (count < 4) {  // open the largest child that can be split
            int largest = -1;
            for (int i = 0; i < count; ++i)
                if (!is_leaf[i] &&
                    (largest < 0 || children[i].box.half_area() > children[largest].box.half_area()))
                    largest = i;
            if (largest < 0) break;
            Range left, right;
            if (split(children[largest], left, right)) {
                children[largest] = left;
                children[count++] = right;
            } else {
                is_leaf[largest] = true;
            }
        }
        const auto index = static_cast<std::int32_t>(bvh.nodes_.size());
        bvh.nodes_.emplace_back();
        for (int i = 0; i < 4; ++i) {
            std::int32_t child = empty_leaf;
            if (i < count) {
                Range left, right;
                const bool inner = !is_leaf[i] && split(children[i], left, right);
                child = inner ? make_node(left, right) : make_leaf(children[i]);
            }
            set_child(bvh.nodes_[static_cast<std::size_t>(index)], i,
                      i < count ? children[i].box : FloatBox{}, child);
        }
        return index;
    }

    std::int32_t make_leaf(const Range& range) {
        const auto first = static_cast<std::int32_t>(bvh.items_.size());
        for (std::size_t i = range.begin; i < range.end; ++i) bvh.items_.push_back(items[i].id());
        bvh.items_.push_back(end_of_leaf);
        return ~first;
    }

    void set_child(Node& node, int lane, const FloatBox& box, std::int32_t child) const {
        for (int axis = 0; axis < 3; ++axis) {
            node.plane[0][axis][lane] = box.lo[axis] - pad;
            node.plane[1][axis][lane] = box.hi[axis] + pad;
        }
        node.child[lane] = child;
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

void Bvh::build(std::vector<Item> items) {
    nodes_.clear();
    items_.clear();
    if (items.empty()) return;
    Builder builder{*this, std::move(items), 0};
    const std::size_t item_count = builder.items.size();
    FloatBox whole;
    for (const Item& item : builder.items) whole.extend(box_of(item));
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
    const double pad = 2.5e-7 * reach;  // two roundings to single precision, the plane's and the ray's
    box_.lo -= Vec3(pad);
    box_.hi += Vec3(pad);
    builder.pad = static_cast<float>(pad);

    const Builder::Range all{0, item_count, whole, 0};
    Builder::Range left, right;
    nodes_.reserve(item_count / 2 + 1);  // more than is needed mostly; what is not touched takes no memory
    items_.reserve(item_count + item_count / 2);
    items_.push_back(end_of_leaf);  // the empty leaf
    if (builder.split(all, left, right)) {
        builder.make_node(left, right);
    } else {
        nodes_.emplace_back();
        builder.set_child(nodes_[0], 0, whole, builder.make_leaf(all));
        for (int lane = 1; lane < 4; ++lane) builder.set_child(nodes_[0], lane, FloatBox{}, empty_leaf);
    }
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
