// Which pixels are traced and which are interpolated between them.
//
// Samples first lie on a quincunx: every line of a set of base lines holds some, those of the next line
// midway between them. Then the base lines are filled, then the columns between base lines. Wherever the two
// ends of a gap differ, its middle is traced and both halves are looked at again; elsewhere the gap is
// interpolated.
#pragma once

#include <functional>
#include <vector>

#include "rt/programs/pixel_tracer.h"

namespace infra {

/// Where the first samples lie.
class SampleGrid {
  public:
    /// spacing: about one sample for spacing x spacing pixels, >= 1. first_row: rows above it need none.
    SampleGrid(int width, int height, int spacing, int first_row = 0);

    /// Rows of the base lines, from first_row to height-1.
    const std::vector<int>& rows() const { return rows_; }
    /// Columns of the samples on base line `line`, from 0 to width-1.
    const std::vector<int>& columns(int line) const { return columns_[line % 2]; }

  private:
    std::vector<int> rows_;
    std::vector<int> columns_[2];
};

/// Fills in the pixels between samples. One per thread.
class GapFiller {
  public:
    using TracePixel = std::function<void(int column, int row)>;

    /// contrast: relative difference in any channel (or in depth, if the frame has it) that asks for more
    /// samples.
    GapFiller(const SampleGrid& grid, Frame& frame, double contrast, TracePixel trace);

    /// Traces the samples on a base line, from number `begin` to before number `end`.
    void trace_samples(int line, std::size_t begin, std::size_t end);
    /// Fills a base line; its samples and those of its neighbours must be there.
    void fill_line(int line);
    /// Fills the rows between base lines `line` and `line + 1`, which must be full.
    void fill_below(int line);

  private:
    struct Gap;

    bool differ(int column_a, int row_a, int column_b, int row_b) const;
    bool neighbours_differ(int line, int left, int right) const;
    int fill(const Gap& gap, int expected);
    void interpolate(const Gap& gap, int middle);

    const SampleGrid& grid_;
    Frame& frame_;
    double contrast_;
    TracePixel trace_;
};

}  // namespace infra
