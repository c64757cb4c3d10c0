// Tables of numbers over any number of coordinates, interpolated linearly: what data files and pictures in a
// scene become. Immutable, so that all threads share them; a lookup does not allocate.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace infra {

/// The places along one coordinate at which a table has values.
class DataAxis {
  public:
    /// Two neighbouring values and their shares in the result.
    struct Cell {
        std::size_t index;  ///< of the first of the two
        double first, second;
    };

    /// `count` places from `begin` to `end`, evenly spaced. count >= 2, begin != end.
    DataAxis(double begin, double end, std::size_t count);
    /// At least two places, rising or falling.
    explicit DataAxis(std::vector<double> places);

    std::size_t size() const { return size_; }
    double begin() const { return begin_; }
    double end() const { return end_; }
    bool even() const { return places_.empty(); }

    /// Where `coordinate` lies. Beyond an end the values go on linearly for one step; further out they fall
    /// to zero as one over the distance, before the begin without a leap and beyond the end with one to a
    /// third. Not a number gives shares that are none.  source: RADIANCE 6.1, measured
    Cell locate(double coordinate) const;

  private:
    double begin_, end_;
    std::size_t size_;
    double steps_per_unit_ = 0;
    std::vector<double> places_;  ///< empty: evenly spaced
};

class DataTable {
  public:
    static constexpr std::size_t most_dimensions = 16;

    /// values: one for each combination of places, those of the last axis next to each other. 1 to
    /// most_dimensions axes.
    DataTable(std::vector<DataAxis> axes, std::vector<float> values);

    std::size_t dimensions() const { return axes_.size(); }
    const DataAxis& axis(std::size_t i) const { return axes_[i]; }
    const DataAxis& last_axis() const { return axes_.back(); }

    /// Interpolated value. shape: point has a coordinate for each axis.
    double value(std::span<const double> point) const;

    /// Interpolated values at all places of the last axis. shape: point has a coordinate for each axis but
    /// the last, `values` the size of the last.
    void vector(std::span<const double> point, std::span<double> values) const;

  private:
    using Cells = std::array<DataAxis::Cell, most_dimensions>;

    void locate(std::span<const double> point, Cells& cells) const;
    double blend(const Cells& cells, std::size_t axis, const float* values) const;
    void add_rows(const Cells& cells, std::size_t axis, const float* values, double share,
                  std::span<double> sum) const;

    std::vector<DataAxis> axes_;
    std::vector<std::size_t> strides_;  ///< in values_ from one place of an axis to the next
    std::vector<float> values_;
};

}  // namespace infra
