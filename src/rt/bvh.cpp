#include "rt/bvh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace infra {
namespace {

constexpr int bin_count = 16;
constexpr int leaf_size = 4;
constexpr int deepest = 60;  // of the binary tree; a walk's stack holds three entries a level

double half_area(const Box& b) {
    if (b.empty()) return 0;
    const Vec3 d = b.hi - b.lo;
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

}  // namespace

struct Bvh::Builder {
    struct Item {
        Box box;
        std::uint32_t id;
    };
    struct Range {
        std::size_t begin, end;
        Box box;
        int depth;
        std::size_t size() const { return end - begin; }
    };

    Bvh& bvh;
    std::vector<Item> items;
    double pad;

    Box bound(std::size_t begin, std::size_t end) const {
        Box box;
        for (std::size_t i = begin; i < end; ++i) box.extend(items[i].box);
        return box;
    }

    // Splits a range in two by the surface area heuristic; false if it had better stay a leaf.
    bool split(const Range& range, Range& left, Range& right) {
        if (range.size() <= leaf_size || range.depth >= deepest) return false;
        Box centers;
        for (std::size_t i = range.begin; i < range.end; ++i) centers.extend((items[i].box.lo + items[i].box.hi) * 0.5);
        double best_cost = std::numeric_limits<double>::infinity();
        int best_axis = -1, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double extent = centers.hi[axis] - centers.lo[axis];
            if (!(extent > 0)) continue;
            Box box[bin_count];
            std::size_t count[bin_count] = {};
            for (std::size_t i = range.begin; i < range.end; ++i) {
                const int b = bin(items[i].box, axis, centers.lo[axis], extent);
                box[b].extend(items[i].box);
                ++count[b];
            }
            double right_cost[bin_count];
            Box sum;
            std::size_t n = 0;
            for (int b = bin_count - 1; b > 0; --b) {
                sum.extend(box[b]);
                n += count[b];
                right_cost[b] = half_area(sum) * static_cast<double>(n);
            }
            sum = Box{};
            n = 0;
            for (int b = 0; b < bin_count - 1; ++b) {
                sum.extend(box[b]);
                n += count[b];
                const double cost = half_area(sum) * static_cast<double>(n) + right_cost[b + 1];
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
            const double low = centers.lo[best_axis], extent = centers.hi[best_axis] - low;
            middle = static_cast<std::size_t>(
                std::partition(items.begin() + static_cast<std::ptrdiff_t>(range.begin),
                               items.begin() + static_cast<std::ptrdiff_t>(range.end),
                               [&](const Item& item) { return bin(item.box, best_axis, low, extent) <= best_bin; }) -
                items.begin());
        }
        left = {range.begin, middle, bound(range.begin, middle), range.depth + 1};
        right = {middle, range.end, bound(middle, range.end), range.depth + 1};
        return true;
    }

    static int bin(const Box& box, int axis, double low, double extent) {
        const double center = 0.5 * (box.lo[axis] + box.hi[axis]);
        return std::min(bin_count - 1, static_cast<int>((center - low) / extent * bin_count));
    }

    // Makes the node of a range that has been split at least once; returns its index.
    std::int32_t make_node(const Range& a, const Range& b) {
        Range children[4] = {a, b, {}, {}};
        bool is_leaf[4] = {false, false, false, false};
        int count = 2;
        while (count < 4) {  // open the largest child that can be split
            int largest = -1;
            for (int i = 0; i < count; ++i)
                if (!is_leaf[i] && (largest < 0 || half_area(children[i].box) > half_area(children[largest].box)))
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
            set_child(bvh.nodes_[static_cast<std::size_t>(index)], i, i < count ? children[i].box : Box{}, child, items_in_leaf);
        }
        return index;
    }

    void set_child(Node& node, int lane, const Box& box, std::int32_t child, std::int32_t count) const {
        for (int axis = 0; axis < 3; ++axis) {
            node.plane[0][axis][lane] = static_cast<float>(box.lo[axis] - pad);
            node.plane[1][axis][lane] = static_cast<float>(box.hi[axis] + pad);
        }
        node.child[lane] = child;
        node.count[lane] = count;
    }
};

void Bvh::build(std::vector<Box> boxes, std::vector<std::uint32_t> ids) {
    nodes_.clear();
    items_.clear();
    if (ids.empty()) return;
    Builder builder{*this, {}, 0};
    builder.items.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) builder.items.push_back({boxes[i], ids[i]});
    boxes = {};
    ids = {};
    box_ = builder.bound(0, builder.items.size());
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis)
        reach = std::max({reach, std::fabs(box_.lo[axis]), std::fabs(box_.hi[axis])});
    builder.pad = 2.5e-7 * reach;  // two roundings to single precision, the plane's and the ray's
    box_.lo -= Vec3(builder.pad);
    box_.hi += Vec3(builder.pad);

    const Builder::Range whole{0, builder.items.size(), box_, 0};
    Builder::Range left, right;
    if (builder.split(whole, left, right)) {
        builder.make_node(left, right);
    } else {
        nodes_.emplace_back();
        builder.set_child(nodes_[0], 0, box_, 0, static_cast<std::int32_t>(whole.size()));
        for (int lane = 1; lane < 4; ++lane) builder.set_child(nodes_[0], lane, Box{}, -1, -1);
    }
    nodes_.shrink_to_fit();
    items_.reserve(builder.items.size());
    for (const Builder::Item& item : builder.items) items_.push_back(item.id);
}

}  // namespace infra
