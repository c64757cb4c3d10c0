#include "bsdf/slice_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.h"

namespace infra {

SliceSet::SliceSet(const TensorTree& tree, bool from_outgoing)
    : tree_(&tree),
      incident_count_(static_cast<std::size_t>(tree.rank()) - 2),
      incident_first_(from_outgoing ? 2 : 0),
      outgoing_first_(from_outgoing ? 0 : incident_count_),
      turned_(from_outgoing) {
    const double width = incident_count_ == 1 ? 0.5 : 1.0;  // of rank 3 one half is used
    regions_.push_back({width});
    fill(0, {{0, 0}, width});
    tree_ = nullptr;
    pending_ = {};
}

// One slice for the whole region if its cells reach over it, else regions of half the width.
void SliceSet::fill(std::size_t number, const Place& place) {
    const std::size_t before = cells_.size();
    if (gather(0, {}, 1.0, place)) {
        regions_[number].first = static_cast<std::uint32_t>(slices_.size());
        slices_.push_back(finish_slice());
        return;
    }
    cells_.resize(before);
    pending_.clear();
    const std::size_t first = regions_.size(), parts = std::size_t(1) << incident_count_;
    const double half = 0.5 * place.width;
    regions_[number].first = static_cast<std::uint32_t>(first);
    regions_[number].divided = true;
    regions_.resize(first + parts, Region{half});
    for (std::size_t part = 0; part < parts; ++part) {
        Place within{place.incident, half};
        for (std::size_t i = 0; i < incident_count_; ++i)
            if (part >> i & 1) within.incident[i] += half;
        fill(first + part, within);
    }
}

// Collects the cells below a node that cover the region. False if one is smaller than it.
bool SliceSet::gather(std::size_t number, const TreePoint& corner, double width, const Place& place) {
    const TensorTree::Node& node = tree_->nodes()[number];
    if (node.log2_grid == TensorTree::Node::divided) {
        return width > place.width && gather_children(node, corner, width, place);
    }
    const double step = std::ldexp(width, -node.log2_grid);
    if (step < place.width) return false;
    gather_grid(node, corner, step, place);
    return true;
}

bool SliceSet::gather_children(const TensorTree::Node& node, const TreePoint& corner, double width,
                               const Place& place) {
    const double half = 0.5 * width;
    std::size_t fixed = 0;
    for (std::size_t i = 0; i < incident_count_; ++i)
        if (place.incident[i] >= corner[incident_first_ + i] + half)
            fixed |= std::size_t(1) << (incident_first_ + i);
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const std::size_t child = fixed | quarter << outgoing_first_;
        TreePoint at = corner;
        for (std::size_t i = 0; i < at.size(); ++i)
            if (child >> i & 1) at[i] += half;
        if (!gather(node.first + child, at, half, place)) return false;
    }
    return true;
}

void SliceSet::gather_grid(const TensorTree::Node& node, const TreePoint& corner, double step,
                           const Place& place) {
    const auto rank = static_cast<std::size_t>(tree_->rank());
    const auto log2 = static_cast<std::size_t>(node.log2_grid);
    const auto shift = [&](std::size_t dimension) { return log2 * (rank - 1 - dimension); };
    std::size_t fixed = 0;
    for (std::size_t i = 0; i < incident_count_; ++i) {
        const std::size_t dimension = incident_first_ + i;
        const auto index = static_cast<std::size_t>((place.incident[i] - corner[dimension]) / step);
        fixed += index << shift(dimension);
    }
    const std::size_t side = std::size_t(1) << log2;
    for (std::size_t x = 0; x < side; ++x)
        for (std::size_t y = 0; y < side; ++y) {
            TreePoint at = corner;
            at[outgoing_first_] += step * static_cast<double>(x);
            at[outgoing_first_ + 1] += step * static_cast<double>(y);
            const std::size_t n = fixed + (x << shift(outgoing_first_)) + (y << shift(outgoing_first_ + 1));
            add_cell(at, step, tree_->value(node.first + n));
        }
}

void SliceSet::add_cell(const TreePoint& corner, double width, float value) {
    if (cells_.size() >= most_cells)
        throw Error("the tensor tree is too detailed: its tables for sampling would not fit into memory",
                    "rttree_reduce simplifies it");
    double x = corner[outgoing_first_], y = corner[outgoing_first_ + 1];
    if (turned_) {
        x = 1 - x - width;
        y = 1 - y - width;
    }
    constexpr double units = 1 << TensorTree::finest;
    cells_.push_back({static_cast<std::uint16_t>(x * units), static_cast<std::uint16_t>(y * units),
                      static_cast<std::uint8_t>(-std::ilogb(width))});
    pending_.push_back(value);
}

SliceSet::Slice SliceSet::finish_slice() {
    Slice slice;
    slice.begin = static_cast<std::uint32_t>(cumulative_.size());
    double sum = 0;
    for (std::size_t n = 0; n < pending_.size(); ++n) {
        const double width = std::ldexp(1.0, -cells_[slice.begin + n].level);
        sum += static_cast<double>(pending_[n]) * width * width;
        cumulative_.push_back(static_cast<float>(sum));
        slice.least_width = std::min(slice.least_width, width);
        slice.largest_width = std::max(slice.largest_width, width);
    }
    pending_.clear();
    slice.end = static_cast<std::uint32_t>(cumulative_.size());
    slice.total = std::numbers::pi * sum;
    largest_total_ = std::max(largest_total_, slice.total);
    least_width_ = std::min(least_width_, slice.least_width);
    return slice;
}

const SliceSet::Slice& SliceSet::slice_at(const Point2& incident) const {
    Point2 corner = {0, 0};
    const Region* region = &regions_.front();
    while (region->divided) {
        const double half = 0.5 * region->width;
        std::size_t part = 0;
        for (std::size_t i = 0; i < incident_count_; ++i)
            if (incident[i] >= corner[i] + half) {
                corner[i] += half;
                part |= std::size_t(1) << i;
            }
        region = &regions_[region->first + part];
    }
    return slices_[region->first];
}

SliceSet::Square SliceSet::choose(const Slice& slice, double choice) const {
    const auto first = cumulative_.begin() + slice.begin, last = cumulative_.begin() + slice.end - 1;
    const auto found = std::upper_bound(first, last, static_cast<float>(choice * *last));
    const Cell& cell = cells_[static_cast<std::size_t>(found - cumulative_.begin())];
    constexpr double unit = 1.0 / (1 << TensorTree::finest);
    return {{cell.x * unit, cell.y * unit}, std::ldexp(1.0, -cell.level)};
}

}  // namespace infra
