#include "rt/programs/adaptive_sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace infra {
namespace {

using Image = double (*)(int column, int row);

/// Renders a known image and counts what was traced.
struct Rendering {
    Frame frame;
    std::vector<int> traced;
    int total = 0;

    Rendering(int width, int height, int spacing, Image image, bool with_depth = false,
              Image depth = nullptr) {
        frame.picture.width = width;
        frame.picture.height = height;
        frame.picture.channels = 1;
        frame.picture.pixels.assign(static_cast<std::size_t>(width) * height, -1.0f);
        if (with_depth) frame.depth.assign(frame.picture.pixels.size(), -1.0f);
        traced.assign(frame.picture.pixels.size(), 0);
        const SampleGrid grid(width, height, spacing);
        GapFiller filler(grid, frame, 0.05, [&](int column, int row) {
            const std::size_t index = static_cast<std::size_t>(row) * width + column;
            ++traced[index];
            ++total;
            frame.picture.pixels[index] = static_cast<float>(image(column, row));
            if (with_depth) frame.depth[index] = static_cast<float>(depth(column, row));
        });
        const int lines = static_cast<int>(grid.rows().size());
        for (int line = 0; line < lines; ++line) filler.trace_samples(line, 0, grid.columns(line).size());
        for (int line = 0; line < lines; ++line) filler.fill_line(line);
        for (int line = 0; line + 1 < lines; ++line) filler.fill_below(line);
    }

    int most_often() const { return *std::max_element(traced.begin(), traced.end()); }
};

double flat(int, int) { return 2; }
double edge(int column, int row) { return column + 2 * row < 50 ? 1 : 3; }
double ramp(int column, int row) { return 10 + 0.01 * column + 0.02 * row; }

TEST(SampleGrid, is_a_quincunx) {
    const SampleGrid grid(20, 10, 4);
    EXPECT_EQ(grid.rows(), (std::vector<int>{0, 3, 6, 9}));
    EXPECT_EQ(grid.columns(0), (std::vector<int>{0, 6, 12, 18, 19}));
    EXPECT_EQ(grid.columns(1), (std::vector<int>{0, 3, 9, 15, 19}));
    EXPECT_EQ(grid.columns(2), grid.columns(0));
}

TEST(SampleGrid, may_begin_below_the_top) {
    const std::vector<int> rows = SampleGrid(20, 10, 4, 3).rows();
    EXPECT_EQ(rows, (std::vector<int>{3, 6, 9}));
    EXPECT_EQ(SampleGrid(20, 10, 4, 9).rows(), std::vector<int>{9});
}

TEST(SampleGrid, reaches_both_ends_of_any_size) {
    for (int width = 1; width < 30; ++width)
        for (int spacing = 1; spacing <= 16; ++spacing) {
            const SampleGrid grid(width, width, spacing);
            for (const auto* list : {&grid.rows(), &grid.columns(0), &grid.columns(1)}) {
                EXPECT_EQ(list->front(), 0);
                EXPECT_EQ(list->back(), width - 1);
                for (std::size_t i = 1; i < list->size(); ++i) EXPECT_LT((*list)[i - 1], (*list)[i]);
            }
        }
}

TEST(GapFiller, traces_every_pixel_at_spacing_1) {
    const Rendering result(17, 13, 1, edge);
    EXPECT_EQ(result.total, 17 * 13);
    EXPECT_EQ(result.most_often(), 1);
}

TEST(GapFiller, traces_the_grid_alone_where_nothing_changes) {
    const Rendering result(65, 65, 4, flat);
    EXPECT_LT(result.total, 65 * 65 / 12);
    for (const float value : result.frame.picture.pixels) EXPECT_EQ(value, 2);
}

TEST(GapFiller, interpolates_a_slow_ramp_exactly) {
    const Rendering result(60, 40, 4, ramp);
    EXPECT_LT(result.total, 60 * 40 / 10);
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 60; ++column)
            EXPECT_NEAR(result.frame.picture.at(column, row)[0], ramp(column, row), 1e-5);
}

TEST(GapFiller, finds_an_edge) {
    const Rendering result(64, 48, 4, edge);
    EXPECT_LT(result.total, 64 * 48 / 2);
    EXPECT_EQ(result.most_often(), 1);
    int wrong = 0;
    for (int row = 0; row < 48; ++row)
        for (int column = 0; column < 64; ++column)
            if (result.frame.picture.at(column, row)[0] != static_cast<float>(edge(column, row))) ++wrong;
    EXPECT_EQ(wrong, 0);
}

TEST(GapFiller, follows_edges_of_depth_when_there_is_depth) {
    const Rendering without(64, 48, 4, flat);
    const Rendering with(64, 48, 4, flat, true, edge);
    EXPECT_GT(with.total, without.total);
    for (int row = 0; row < 48; ++row)
        for (int column = 0; column < 64; ++column)
            EXPECT_EQ(with.frame.depth[row * 64 + column], static_cast<float>(edge(column, row)));
}

TEST(GapFiller, leaves_no_pixel_out_whatever_the_size) {
    for (const int width : {1, 2, 3, 7, 20})
        for (const int height : {1, 2, 5, 16})
            for (const int spacing : {1, 2, 3, 4, 8, 16}) {
                const Rendering result(width, height, spacing, flat);
                for (const float value : result.frame.picture.pixels) EXPECT_EQ(value, 2);
                EXPECT_EQ(result.most_often(), 1);
            }
}

}  // namespace
}  // namespace infra
