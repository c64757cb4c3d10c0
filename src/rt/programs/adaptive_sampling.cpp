#include "rt/programs/adaptive_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace infra {
namespace {

/// Samples worth placing in a gap beside which the picture changes: its middle, then the middles of both
/// halves. Found by trial: as few pixels off as RADIANCE leaves, for some tenth fewer rays.
constexpr int expected_at_edge = 3;

/// 0, first, first + step, ... , last.
std::vector<int> positions(int first, int step, int last) {
    std::vector<int> result{0};
    for (int at = first; at < last; at += step)
        if (at > 0) result.push_back(at);
    if (last > 0) result.push_back(last);
    return result;
}

}  // namespace

SampleGrid::SampleGrid(int width, int height, int spacing, int first_row) {
    // On a quincunx the samples of a line are twice as far apart as the lines.
    const int step_x = std::max(1, static_cast<int>(std::lround(spacing * std::numbers::sqrt2)));
    const int step_y = std::max(1, static_cast<int>(std::lround(spacing / std::numbers::sqrt2)));
    rows_ = positions(step_y, step_y, height - 1 - first_row);
    for (int& row : rows_) row += first_row;
    columns_[0] = positions(step_x, step_x, width - 1);
    columns_[1] = positions(step_x / 2, step_x, width - 1);
}

/// Pixels from one that is known to another one `length` further on, along a row or down a column.
struct GapFiller::Gap {
    int column, row;
    int step_x, step_y;
    int length;

    int column_at(int i) const { return column + i * step_x; }
    int row_at(int i) const { return row + i * step_y; }
    Gap part(int begin, int end) const {
        return {column_at(begin), row_at(begin), step_x, step_y, end - begin};
    }
};

GapFiller::GapFiller(const SampleGrid& grid, Frame& frame, double contrast, TracePixel trace)
    : grid_(grid), frame_(frame), contrast_(contrast), trace_(std::move(trace)) {}

bool GapFiller::differ(int column_a, int row_a, int column_b, int row_b) const {
    const std::span<const float> a = frame_.picture.at(column_a, row_a);
    const std::span<const float> b = frame_.picture.at(column_b, row_b);
    for (int band = 0; band < frame_.bands(); ++band) {
        const float x = frame_.total(a, band), y = frame_.total(b, band);
        if (std::abs(x - y) > contrast_ * std::min(x, y)) return true;
    }
    if (frame_.depth.empty()) return false;
    const float za = frame_.depth[static_cast<std::size_t>(row_a) * frame_.picture.width + column_a];
    const float zb = frame_.depth[static_cast<std::size_t>(row_b) * frame_.picture.width + column_b];
    return 2 * std::abs(za - zb) > contrast_ * (za + zb);
}

/// Whether the samples just above and below the gap between two samples differ from either of them.
bool GapFiller::neighbours_differ(int line, int left, int right) const {
    const std::vector<int>& rows = grid_.rows();
    for (const int other : {line - 1, line + 1}) {
        if (other < 0 || other >= static_cast<int>(rows.size())) continue;
        const std::vector<int>& columns = grid_.columns(other);
        for (auto it = std::upper_bound(columns.begin(), columns.end(), left);
             it != columns.end() && *it < right; ++it)
            if (differ(left, rows[line], *it, rows[other]) || differ(right, rows[line], *it, rows[other]))
                return true;
    }
    return false;
}

void GapFiller::trace_samples(int line, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) trace_(grid_.columns(line)[i], grid_.rows()[line]);
}

void GapFiller::fill_line(int line) {
    const std::vector<int>& columns = grid_.columns(line);
    int found = 0;
    for (std::size_t i = 1; i < columns.size(); ++i) {
        const int left = columns[i - 1], right = columns[i];
        const int expected = std::max(found / 2, neighbours_differ(line, left, right) ? expected_at_edge : 0);
        found = fill({left, grid_.rows()[line], 1, 0, right - left}, expected);
    }
}

void GapFiller::fill_below(int line) {
    const int top = grid_.rows()[line], bottom = grid_.rows()[line + 1];
    int found = 0;
    for (int column = 0; column < frame_.picture.width; ++column)
        found = fill({column, top, 0, 1, bottom - top}, found / 2);
}

/// Returns how many pixels were traced. As many as `expected`, which tells what happened next door, are
/// traced where the ends of the gap alone would not ask for it.
int GapFiller::fill(const Gap& gap, int expected) {
    if (gap.length < 2) return 0;
    const int middle = gap.length / 2;
    int traced = 0;
    if (expected > 0 || differ(gap.column, gap.row, gap.column_at(gap.length), gap.row_at(gap.length))) {
        trace_(gap.column_at(middle), gap.row_at(middle));
        traced = 1;
    } else {
        interpolate(gap, middle);
    }
    const int rest = std::max(expected - 1, 0);
    traced += fill(gap.part(0, middle), rest / 2);
    traced += fill(gap.part(middle, gap.length), (rest + 1) / 2);
    return traced;
}

void GapFiller::interpolate(const Gap& gap, int middle) {
    const float t = static_cast<float>(middle) / static_cast<float>(gap.length);
    Picture& picture = frame_.picture;
    const std::span<float> target = picture.at(gap.column_at(middle), gap.row_at(middle));
    const std::span<const float> a = picture.at(gap.column, gap.row);
    const std::span<const float> b = picture.at(gap.column_at(gap.length), gap.row_at(gap.length));
    for (std::size_t c = 0; c < target.size(); ++c) target[c] = a[c] + t * (b[c] - a[c]);
    if (frame_.depth.empty()) return;
    const auto depth = [&](int i) -> float& {
        return frame_.depth[static_cast<std::size_t>(gap.row_at(i)) * picture.width + gap.column_at(i)];
    };
    depth(middle) = depth(0) + t * (depth(gap.length) - depth(0));
}

}  // namespace infra
