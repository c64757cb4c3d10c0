#include "rt/geometry/bvh.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "common/error.h"

namespace infra {
namespace {

constexpr int most_bins = 16;
constexpr std::size_t few_items = 64;       // for which half the bins do
constexpr std::size_t sampled_items = 128;  // as many stand for all of a range of twice as many or more
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

    // What is no number in the other box, is left out.
    void extend(const FloatBox& other) {
        lo = other.lo < lo ? other.lo : lo;
        hi = other.hi > hi ? other.hi : hi;
    }
    /// This box, or what is no number.
    FloatBox only_if(const Int4& mask) const {
        const auto all_bits_if_not = [&mask](const Float4& numbers) {
            return std::bit_cast<Float4>(std::bit_cast<Int4>(numbers) | ~mask);
        };
        return {all_bits_if_not(lo), all_bits_if_not(hi)};
    }
    float half_area() const {
        if (lo[0] > hi[0]) return 0;
        const Float4 d = hi - lo;
        return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }
};

FloatBox box_of(const Bvh::Item& item) { return {load(item.lo), load(item.hi)}; }

/// Boxes of three axes' halves of a range, and their half areas by axis.
struct ThreeBoxes {
    FloatBox box[3];

    void extend(const FloatBox (&others)[3]) {
        for (int axis = 0; axis < 3; ++axis) box[axis].extend(others[axis]);
    }
    /// Of no meaning for empty boxes.
    Float4 half_areas() const {
        const Float4 a = box[0].hi - box[0].lo, b = box[1].hi - box[1].lo, c = box[2].hi - box[2].lo;
        const Float4 x = {a[0], b[0], c[0], 0}, y = {a[1], b[1], c[1], 0}, z = {a[2], b[2], c[2], 0};
        return x * y + y * z + z * x;
    }
};

/// Around the centres of items, all coordinates doubled.
struct Centers {
    FloatBox centers;

    void extend(const FloatBox& item) {
        const Float4 center = item.lo + item.hi;
        centers.extend({center, center});
    }
};

/// Around items and their centres.
struct Extent : Centers {
    FloatBox box;

    void extend(const FloatBox& item) {
        Centers::extend(item);
        box.extend(item);
    }
    void extend(const Centers& others) { centers.extend(others.centers); }
    void extend(const Extent& others) {
        centers.extend(others.centers);
        box.extend(others.box);
    }
};

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
        return __builtin_convertvector((box.lo + box.hi - low) * scale, Int4);
    }
    /// Where along one axis, in bins.
    float operator()(const Bvh::Item& item, int axis) const {
        return (item.lo[axis] + item.hi[axis] - low[axis]) * scale[axis];
    }
};

/// The next number towards infinity.
float next_above(float x) {
    const auto bits = std::bit_cast<std::int32_t>(x + 0.0f);  // no negative zero
    return std::bit_cast<float>(bits + (bits >> 31 | 1));
}

double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Of the largest power of two that is no larger than x; x must be positive and not tiny.
int exponent_of(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023; }

constexpr int least_exponent = -100;  // of steps

/// Steps of a power of two from an origin; so many of them reach from lo to hi, on one axis.
struct Steps {
    float origin;
    int exponent;

    Steps(double lo, double hi, int count) : origin(static_cast<float>(lo)) {
        if (origin > lo) origin = -next_above(-origin);
        const double step = (hi - origin) / count;
        exponent = step > 0 ? std::max(exponent_of(step), least_exponent) : least_exponent;
        if (count * power_of_two(exponent) < hi - origin) ++exponent;
    }
    double per_unit() const { return power_of_two(-exponent); }
    std::uint8_t biased_exponent() const { return static_cast<std::uint8_t>(exponent + 127); }
};

}  // namespace

struct Bvh::Builder {
    struct Range {
        std::size_t begin, end;
        Extent extent;
        int depth;
        float half_area;

        Range() = default;
        Range(std::size_t first, std::size_t behind, const Extent& items_extent, int range_depth)
            : begin(first),
              end(behind),
              extent(items_extent),
              depth(range_depth),
              half_area(items_extent.box.half_area()) {}
        std::size_t size() const { return end - begin; }
    };

    /// Where to part a range: at a border of bins along an axis.
    struct Place {
        int axis = -1;  ///< none if all centres are in one place
        int bin = 0;    ///< the last that belongs to the left part
    };

    Bvh& bvh;
    LargeVector<Item>& items;
    std::size_t triangle_count;
    LeafTriangles& triangles;
    double pad;

    bool mixed(const Range& range) const {
        return range.begin < triangle_count && range.end > triangle_count;
    }
    bool is_leaf(const Range& range) const {
        return range.size() <= (range.begin < triangle_count ? triangles_a_leaf : others_a_leaf) &&
               !mixed(range);
    }

    Extent extent_of(std::size_t begin, std::size_t end) const {
        Extent extent;
        for (std::size_t i = begin; i < end; ++i) extent.extend(box_of(items[i]));
        return extent;
    }

    // Splits a range in two by the surface area heuristic; false if it had better stay a leaf.
    bool split(const Range& range, Range& left, Range& right) {
        if (is_leaf(range)) return false;
        const auto split_at = [&](std::size_t middle) {
            left = {range.begin, middle, extent_of(range.begin, middle), range.depth + 1};
            right = {middle, range.end, extent_of(middle, range.end), range.depth + 1};
        };
        if (mixed(range)) {
            split_at(triangle_count);
            return true;
        }
        const bool parted = range.depth < halving_depth &&
                            (range.size() < few_items ? split_at_bin<most_bins / 2>(range, left, right)
                                                      : split_at_bin<most_bins>(range, left, right));
        if (!parted) split_at(range.begin + range.size() / 2);
        return true;
    }

    // False if all centres are in one place.
    template <int bins>
    bool split_at_bin(const Range& range, Range& left, Range& right) {
        const Binning bin(range.extent.centers, bins);
        Extent parts[2];
        const Place place = place_to_split<bins>(range, bin, parts);
        if (place.axis < 0) return false;
        const std::size_t middle = is_sampled(range) ? part<Extent>(range, bin, place, parts)
                                                     : part<Centers>(range, bin, place, parts);
        left = {range.begin, middle, parts[0], range.depth + 1};
        right = {middle, range.end, parts[1], range.depth + 1};
        return true;
    }

    static bool is_sampled(const Range& range) { return range.size() >= 2 * sampled_items; }

    // Also tells the boxes of the two parts unless the range is only sampled.
    template <int bins>
    Place place_to_split(const Range& range, const Binning& bin, Extent* parts) const {
        FloatBox box[bins][3];
        std::int32_t count[bins][4] = {};
        const std::size_t step = is_sampled(range) ? range.size() / sampled_items : 1;
        std::int32_t all = 0;
        for (std::size_t i = range.begin; i < range.end; i += step, ++all) {
            const FloatBox b = box_of(items[i]);
            const Int4 place = bin(b);
            for (int axis = 0; axis < 3; ++axis) {
                box[place[axis]][axis].extend(b);
                ++count[place[axis]][axis];
            }
        }
        const auto counted = [&count](int b) {
            Int4 counts;
            std::memcpy(&counts, count[b], sizeof counts);
            return counts;
        };
        // By axis: a part's half area times the number of its items.
        Float4 right_cost[bins];
        ThreeBoxes sum;
        Int4 n = {};
        for (int b = bins - 1; b > 0; --b) {
            sum.extend(box[b]);
            n += counted(b);
            right_cost[b] = sum.half_areas() * __builtin_convertvector(n, Float4);
        }
        sum = {};
        n = Int4{};
        Float4 best_cost = {inf, inf, inf, inf};
        Int4 best_bin = {};
        for (int b = 0; b < bins - 1; ++b) {
            sum.extend(box[b]);
            n += counted(b);
            const Float4 cost = sum.half_areas() * __builtin_convertvector(n, Float4) + right_cost[b + 1];
            const Int4 better = (n > 0) & (n < all) & (cost < best_cost);
            best_cost = better ? cost : best_cost;
            best_bin = better ? Int4{b, b, b, b} : best_bin;
        }
        Place best;
        float least = inf;
        for (int axis = 0; axis < 3; ++axis)
            if (best_cost[axis] < least) {
                least = best_cost[axis];
                best = {axis, best_bin[axis]};
            }
        if (best.axis < 0) return best;
        for (int b = 0; b < bins; ++b) parts[b > best.bin].box.extend(box[b][best.axis]);
        return best;
    }

    // Sorts a range's items into two parts and returns where the second begins; adds to what is known of
    // each.
    template <class Known>
    std::size_t part(const Range& range, const Binning& bin, Place place, Extent* parts) {
        const auto border = static_cast<float>(place.bin + 1);
        const Float4 borders = {border, border, border, border};
        Known left, right;
        std::size_t middle = range.begin;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const Item item = items[i];
            const float at = bin(item, place.axis);
            // Without a branch, which would be taken at random. What it exchanges belongs to the right part.
            items[i] = items[middle];
            items[middle] = item;
            middle += at < border;
            const Int4 is_left = Float4{at, at, at, at} < borders;
            const FloatBox box = box_of(item);
            left.extend(box.only_if(is_left));
            right.extend(box.only_if(~is_left));
        }
        parts[0].extend(left);
        parts[1].extend(right);
        return middle;
    }

    // Makes the node of a range; returns its index.
    std::uint32_t make_node(const Range& range) {
        constexpr int width = BvhNode::width;
        Range children[width];
        children[0] = range;
        bool closed[width] = {};
        int count = 1;
        while (count < width) {  // open the largest child that can be split
            int largest = -1;
            for (int i = 0; i < count; ++i)
                if (!closed[i] && (largest < 0 || children[i].half_area > children[largest].half_area))
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
        for (int i = 0; i < count; ++i)
            if (children[i].begin < triangle_count && is_leaf(children[i]))
                triangles.announce({&items[children[i].begin], children[i].size()});
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
        const FloatBox& whole = range.extent.box;
        for (int axis = 0; axis < 3; ++axis) {
            const Steps steps(double{whole.lo[axis]} - pad, double{whole.hi[axis]} + pad, 255);
            node.origin[axis] = steps.origin;
            node.exponent[axis] = steps.biased_exponent();
            const double per_unit = steps.per_unit();
            for (int i = 0; i < count; ++i) {
                const FloatBox& box = children[i].extent.box;
                const double lo = (double{box.lo[axis]} - pad - steps.origin) * per_unit;
                const double hi = (double{box.hi[axis]} + pad - steps.origin) * per_unit;
                const auto whole_hi = static_cast<int>(hi);
                node.plane[0][axis][i] = static_cast<std::uint8_t>(lo);  // none is negative
                node.plane[1][axis][i] = static_cast<std::uint8_t>(whole_hi + (whole_hi < hi));
            }
        }
        return node;
    }

    // Replaces the items of a range of triangles by what the kernel needs of them.
    std::uint32_t make_leaf(const Range& range) {
        if (range.begin < triangle_count) {
            const std::size_t count = range.size();
            std::array<Vec3, 3> corners[BvhLeaf::largest];
            const double uncertainty = triangles.place({&items[range.begin], count}, range.begin, corners);
            Bounds box;
            for (std::size_t i = 0; i < count; ++i)
                for (const Vec3& corner : corners[i]) box.extend(corner);
            BvhLeaf leaf;
            // The kernel takes a step for what a coordinate may be wrong by.
            int exponent =
                uncertainty > 0 ? std::max(exponent_of(uncertainty) + 1, least_exponent) : least_exponent;
            for (int axis = 0; axis < 3; ++axis) {
                const Steps steps(box.lo[axis], box.hi[axis], 65535);
                leaf.origin[axis] = steps.origin;
                exponent = std::max(exponent, steps.exponent);
            }
            leaf.exponent = static_cast<std::uint16_t>(exponent + 127);
            std::uint16_t* row = leaf.rows;
            const double steps_per_unit = power_of_two(-exponent);
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

Bvh::Item::Item(const Bounds& box, std::uint32_t id, std::uint32_t note) {
    for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = -next_above(-static_cast<float>(box.lo[axis]));
        hi[axis] = next_above(static_cast<float>(box.hi[axis]));
    }
    lo[3] = std::bit_cast<float>(id);
    hi[3] = std::bit_cast<float>(note);
}

void Bvh::build(LargeVector<Item> triangle_items, const std::vector<Item>& other_items,
                LeafTriangles& triangles) {
    const std::size_t item_count = triangle_items.size() + other_items.size();
    if (item_count > BvhLeaf::most_slots) throw Error("too many shapes in one octree");
    if (item_count == 0) return;
    leaves_ = std::move(triangle_items);
    triangle_count_ = static_cast<std::uint32_t>(leaves_.size());
    leaves_.insert(leaves_.end(), other_items.begin(), other_items.end());
    Builder builder{*this, leaves_, triangle_count_, triangles, 0};
    others_.resize(other_items.size());
    const Extent extent = builder.extent_of(0, item_count);
    const FloatBox& whole = extent.box;
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
    builder.make_node({0, item_count, extent, 0});
    leaves_.resize(triangle_count_ + 1);  // the kernel loads 16 bytes where fewer are left
    if (!other_items.empty()) leaves_.shrink_to_fit();
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
