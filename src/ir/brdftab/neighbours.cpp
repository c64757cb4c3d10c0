#include "ir/brdftab/neighbours.h"

#include <algorithm>
#include <numeric>

namespace infra::ir {

double squared_distance(const Point3& a, const Point3& b) {
    double sum = 0;
    for (std::size_t n = 0; n < 3; ++n) sum += (a[n] - b[n]) * (a[n] - b[n]);
    return sum;
}

NeighbourSearch::NeighbourSearch(std::vector<Point3> points)
    : points_(std::move(points)), order_(points_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, order_.size(), 0);
}

void NeighbourSearch::build(std::size_t begin, std::size_t end, int axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t n) { return order_.begin() + static_cast<std::ptrdiff_t>(n); };
    std::nth_element(at(begin), at(middle), at(end), [this, axis](std::size_t a, std::size_t b) {
        const double pa = points_[a][static_cast<std::size_t>(axis)];
        const double pb = points_[b][static_cast<std::size_t>(axis)];
        return pa != pb ? pa < pb : a < b;
    });
    build(begin, middle, (axis + 1) % 3);
    build(middle + 1, end, (axis + 1) % 3);
}

void NeighbourSearch::visit(std::size_t begin, std::size_t end, int axis, const Point3& to, std::size_t count,
                            std::vector<Neighbour>& heap) const {
    if (begin >= end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const std::size_t index = order_[middle];
    const Neighbour here{squared_distance(points_[index], to), index};
    if (heap.size() < count || here < heap.front()) {
        if (heap.size() == count) {
            std::pop_heap(heap.begin(), heap.end());
            heap.pop_back();
        }
        heap.push_back(here);
        std::push_heap(heap.begin(), heap.end());
    }
    const double side = to[static_cast<std::size_t>(axis)] - points_[index][static_cast<std::size_t>(axis)];
    const int next = (axis + 1) % 3;
    const auto lower = [&] { visit(begin, middle, next, to, count, heap); };
    const auto upper = [&] { visit(middle + 1, end, next, to, count, heap); };
    // <=, because an equal distance with a smaller index still wins.
    const auto reaches_over = [&] { return heap.size() < count || side * side <= heap.front().distance2; };
    if (side <= 0) {
        lower();
        if (reaches_over()) upper();
    } else {
        upper();
        if (reaches_over()) lower();
    }
}

std::vector<Neighbour> NeighbourSearch::nearest(const Point3& to, std::size_t count) const {
    std::vector<Neighbour> heap;
    count = std::min(count, points_.size());
    heap.reserve(count);
    if (count > 0) visit(0, order_.size(), 0, to, count, heap);
    std::sort_heap(heap.begin(), heap.end());
    return heap;
}

}  // namespace infra::ir
