#include "rt/programs/tiles.h"

#include <gtest/gtest.h>

#include <map>

namespace infra {
namespace {

TEST(Tiles, of_samples_hold_each_sample_once) {
    for (const int spacing : {1, 4})
        for (const std::size_t least : {std::size_t{0}, std::size_t{100}, std::size_t{100000}}) {
            const SampleGrid grid(37, 23, spacing, 2);
            const std::vector<Tile> tiles = tiles_of(grid, Pass::samples, least);
            std::size_t all = 0;
            for (int line = 0; line < int(grid.rows().size()); ++line) all += grid.columns(line).size();
            EXPECT_GE(tiles.size(), std::min(least, all) / 2);  // lines of a quincunx differ in length
            std::map<std::pair<int, int>, int> times;
            for (const Tile& tile : tiles) {
                EXPECT_LT(tile.begin, tile.end);
                for (int i = tile.begin; i < tile.end; ++i) ++times[{tile.line, i}];
            }
            EXPECT_EQ(times.size(), all);
            for (const auto& [sample, count] : times) EXPECT_EQ(count, 1);
        }
}

TEST(Tiles, of_all_passes_hold_each_pixel_once) {
    for (const int spacing : {1, 2, 3, 4, 16})
        for (const int height : {1, 2, 19}) {
            const SampleGrid grid(30, height, spacing);
            std::uint64_t pixels = 0;
            for (const Pass pass : passes_of(grid, 30))
                for (const Tile& tile : tiles_of(grid, pass, 7)) pixels += pixels_of(tile, grid, pass, 30);
            EXPECT_EQ(pixels, 30U * height) << spacing << " " << height;
        }
}

TEST(Tiles, where_every_pixel_is_a_sample_are_of_one_pass) {
    EXPECT_EQ(passes_of(SampleGrid(8, 8, 1), 8).size(), 1U);
    EXPECT_EQ(passes_of(SampleGrid(8, 8, 4), 8).size(), 3U);
    EXPECT_EQ(passes_of(SampleGrid(1, 1, 4), 1).size(), 1U);
}

}  // namespace
}  // namespace infra
