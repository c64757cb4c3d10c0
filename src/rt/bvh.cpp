#include "rt/bvh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace infra {
namespace {

constexpr int bin_count = 16;
constexpr int leaf_size = 4;
constexpr int deepest = 60;  // of the binary tree; a walk's stack holds three entries a level

/// A box in single precision, for building.
struct FloatBox {
    float lo[3] = {inf, inf, inf};
    float hi[3] = {-inf, -inf, -inf};
    static constexpr float inf = std::numeric_limits<float>::infinity();

    void extend(const float* other_lo, const float* other_hi) {
        for (int axis = 0; axis < 3; ++axis) {
            lo[axis] = std::min(lo[axis], other_lo[axis]);
            hi[axis] = std::max(hi[axis], other_hi[axis]);
        }
    }
    void extend(const FloatBox& other) { extend(other.lo, other.hi); }
    float half_area() const {
        if (lo[0] > hi[0]) return 0;
        const float dx = hi[0] - lo[0], dy = hi[1] - lo[1], dz = hi[2] - lo[2];
        return dx * dy + dy * dz + dz * dx;
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

    FloatBox bound(std::size_t begin, std::size_t end) const {
        FloatBox box;
        for (std::size_t i = begin; i < end; ++i) box.extend(items[i].lo, items[i].hi);
        return box;
    }

    static float center(const Item& item, int axis) { return 0.5f * (item.lo[axis] + item.hi[axis]); }

    static int bin(const Item& item, int axis, float low, float scale) {
        return std::min(bin_count - 1, static_cast<int>((center(item, axis) - low) * scale));
    }

    // Splits a range in two by the surface area heuristic; false if it had better stay a leaf.
    bool split(const Range& range, Range& left, Range& right) {
        if (range.size() <= leaf_size || range.depth >= deepest) return false;
        float low[3] = {FloatBox::inf, FloatBox::inf, FloatBox::inf}, scale[3];
        float high[3] = {-FloatBox::inf, -FloatBox::inf, -FloatBox::inf};
        for (std::size_t i = range.begin; i < range.end; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], center(items[i], axis));
                high[axis] = std::max(high[axis], center(items[i], axis));
            }
        FloatBox box[3][bin_count];
        std::uint32_t count[3][bin_count] = {};
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = high[axis] - low[axis];
            scale[axis] = extent > 0 ? bin_count / extent : 0.0f;
        }
        for (std::size_t i = range.begin; i < range.end; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                const int b = bin(items[i], axis, low[axis], scale[axis]);
                box[axis][b].extend(items[i].lo, items[i].hi);
                ++count[axis][b];
            }
        float best_cost = FloatBox::inf;
        int best_axis = -1, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(scale[axis] > 0)) continue;
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
        std::size_t middle;
        if (best_axis < 0) {  // all centres in one place
            middle = range.begin + range.size() / 2;
        } else {
            const auto begin = items.begin();
            middle = static_cast<std::size_t>(
                std::partition(begin + static_cast<std::ptrdiff_t>(range.begin),
                               begin + static_cast<std::ptrdiff_t>(range.end),
                               [&](const Item& item) {
                                   return bin(item, best_axis, low[best_axis], scale[best_axis]) <= best_bin;
                               }) -
                begin);
        }
        left = {range.begin, middle, bound(range.begin, middle), range.depth + 1};
        right = {middle, range.end, bound(middle, range.end), range.depth + 1};
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
                if (!is_leaf[i] && (largest < 0 || children[i].box.half_area() > children[largest].box.half_area()))
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
            std::int32_t child = -1, items_in_leaf = -1;
            if (i < count) {
                Range left, right;
                if (!is_leaf[i] && split(children[i], left, right)) {
                    child = make_node(left, right);
                    items_in_leaf = 0;
                } else {
                    child = static_cast<std::int32_t>(children[i].begin);
                    items_in_leaf = static_cast<std::int32_t>(children[i].size());
                }
            }
            set_child(bvh.nodes_[static_cast<std::size_t>(index)], i, i < count ? children[i].box : FloatBox{}, child,
                      items_in_leaf);
        }
        return index;
    }

    void set_child(Node& node, int lane, const FloatBox& box, std::int32_t child, std::int32_t count) const {
        for (int axis = 0; axis < 3; ++axis) {
            node.plane[0][axis][lane] = box.lo[axis] - pad;
            node.plane[1][axis][lane] = box.hi[axis] + pad;
        }
        node.child[lane] = child;
        node.count[lane] = count;
    }
};

Bvh::Item::Item(const Box& box, std::uint32_t item_id) : id(item_id) {
    for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = std::nextafter(static_cast<float>(box.lo[axis]), -FloatBox::inf);
        hi[axis] = std::nextafter(static_cast<float>(box.hi[axis]), FloatBox::inf);
    }
}

void Bvh::build(std::vector<Item> items) {
    nodes_.clear();
    items_.clear();
    if (items.empty()) return;
    Builder builder{*this, std::move(items), 0};
    const std::size_t item_count = builder.items.size();
    const FloatBox whole = builder.bound(0, item_count);
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
    nodes_.reserve(item_count / 4 + 1);
    if (builder.split(all, left, right)) {
        builder.make_node(left, right);
    } else {
        nodes_.emplace_back();
        builder.set_child(nodes_[0], 0, whole, 0, static_cast<std::int32_t>(item_count));
        for (int lane = 1; lane < 4; ++lane) builder.set_child(nodes_[0], lane, FloatBox{}, -1, -1);
    }
    items_.reserve(item_count);
    for (const Item& item : builder.items) items_.push_back(item.id);
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
