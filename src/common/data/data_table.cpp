#include "common/data/data_table.h"

#include <algorithm>
#include <functional>

namespace infra {

DataAxis::DataAxis(double begin, double end, std::size_t count)
    : begin_(begin),
      end_(end),
      size_(count),
      steps_per_unit_(static_cast<double>(count - 1) / (end - begin)) {}

DataAxis::DataAxis(std::vector<double> places)
    : begin_(places.front()), end_(places.back()), size_(places.size()), places_(std::move(places)) {}

DataAxis::Cell DataAxis::locate(double coordinate) const {
    const std::size_t last_cell = size_ - 2;
    std::size_t i = 0;
    double t;  // 0 at the first of the two places, 1 at the second
    if (even()) {
        const double steps = (coordinate - begin_) * steps_per_unit_;
        if (steps > 0) i = static_cast<std::size_t>(std::min(steps, static_cast<double>(last_cell)));
        t = steps - static_cast<double>(i);
    } else {
        const auto after = begin_ < end_ ? std::ranges::upper_bound(places_, coordinate)
                                         : std::ranges::upper_bound(places_, coordinate, std::greater<>());
        const auto before = static_cast<std::size_t>(after - places_.begin());
        i = before > 0 ? std::min(before - 1, last_cell) : 0;
        t = (coordinate - places_[i]) / (places_[i + 1] - places_[i]);
    }
    if (t > 2) return {i, -1 / (t + 1), 2 / (t + 1)};
    if (t < -1) return {i, -2 / t, 1 / t};
    return {i, 1 - t, t};
}

DataTable::DataTable(std::vector<DataAxis> axes, std::vector<float> values)
    : axes_(std::move(axes)), strides_(axes_.size()), values_(std::move(values)) {
    std::size_t stride = 1;
    for (std::size_t i = axes_.size(); i-- > 0;) {
        strides_[i] = stride;
        stride *= axes_[i].size();
    }
}

void DataTable::locate(std::span<const double> point, Cells& cells) const {
    for (std::size_t i = 0; i < point.size(); ++i) cells[i] = axes_[i].locate(point[i]);
}

double DataTable::value(std::span<const double> point) const {
    Cells cells;
    locate(point, cells);
    return blend(cells, 0, values_.data());
}

double DataTable::blend(const Cells& cells, std::size_t axis, const float* values) const {
    const DataAxis::Cell& cell = cells[axis];
    const float* first = values + cell.index * strides_[axis];
    if (axis + 1 == axes_.size()) return cell.first * first[0] + cell.second * first[1];
    return cell.first * blend(cells, axis + 1, first) +
           cell.second * blend(cells, axis + 1, first + strides_[axis]);
}

void DataTable::vector(std::span<const double> point, std::span<double> values) const {
    Cells cells;
    locate(point, cells);
    std::ranges::fill(values, 0.0);
    add_rows(cells, 0, values_.data(), 1.0, values);
}

void DataTable::add_rows(const Cells& cells, std::size_t axis, const float* values, double share,
                         std::span<double> sum) const {
    if (axis + 1 == axes_.size()) {
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += share * values[k];
        return;
    }
    const DataAxis::Cell& cell = cells[axis];
    const float* first = values + cell.index * strides_[axis];
    add_rows(cells, axis + 1, first, share * cell.first, sum);
    add_rows(cells, axis + 1, first + strides_[axis], share * cell.second, sum);
}

}  // namespace infra
