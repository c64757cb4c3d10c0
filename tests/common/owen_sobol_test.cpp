#include "common/owen_sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace infra {
namespace {

// A (0,2)-sequence: of the first 2^k points every elementary interval of area 2^-k holds one.
TEST(OwenSobol, is_stratified_in_all_elementary_intervals) {
    for (const std::uint64_t seed : {0ull, 1ull, 0xdeadbeefull, 0x123456789abcdefull})
        for (int k = 1; k <= 10; ++k)
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < 1u << k; ++i) {
                    const auto [x, y] = owen_sobol_point(i, seed);
                    ASSERT_TRUE(x >= 0 && x < 1 && y >= 0 && y < 1);
                    cells.emplace(static_cast<int>(std::ldexp(x, a)), static_cast<int>(std::ldexp(y, k - a)));
                }
                EXPECT_EQ(cells.size(), std::size_t{1} << k) << "seed " << seed << " 2^" << k << " by " << a;
            }
}

// Over seeds, each point is uniform: chi-square of 8 x 8 cells, 63 degrees of freedom (99.99 % below 119).
TEST(OwenSobol, every_point_is_uniform_over_seeds) {
    constexpr int seeds = 64000;
    for (const std::uint32_t index : {0u, 1u, 5u, 1000u}) {
        int counts[64] = {};
        for (int s = 0; s < seeds; ++s) {
            const auto [x, y] = owen_sobol_point(index, seed_of(7, static_cast<std::uint64_t>(s)));
            ++counts[static_cast<int>(8 * x) * 8 + static_cast<int>(8 * y)];
        }
        double chi = 0;
        for (const int count : counts) chi += std::pow(count - seeds / 64.0, 2) / (seeds / 64.0);
        EXPECT_LT(chi, 119) << index;
    }
}

// Points of the same index in two sequences: no correlation, so that dimensions can be padded.
TEST(OwenSobol, sequences_of_different_seeds_are_independent) {
    constexpr int seeds = 400, points = 64;
    double sum = 0;
    for (std::uint64_t s = 0; s < seeds; ++s)
        for (std::uint32_t i = 0; i < points; ++i) {
            const auto a = owen_sobol_point(i, seed_of(s, 1)), b = owen_sobol_point(i, seed_of(s, 2));
            sum += (a[0] - .5) * (b[0] - .5) + (a[1] - .5) * (b[1] - .5);
        }
    const double deviation = std::sqrt(2.0 * seeds * points) / 12;  // of a sum of independent products
    EXPECT_LT(std::fabs(sum), 4 * deviation);
}

// The error of a smooth integral falls faster than that of random points.
TEST(OwenSobol, integrates_smooth_functions_better_than_random_points) {
    constexpr int seeds = 200, points = 256;
    double squares = 0;
    for (std::uint64_t s = 0; s < seeds; ++s) {
        double mean = 0;
        for (std::uint32_t i = 0; i < points; ++i) {
            const auto [x, y] = owen_sobol_point(i, seed_of(3, s));
            mean += x * x * y / points;
        }
        squares += std::pow(mean - 1.0 / 6, 2) / seeds;
    }
    const double of_random_points = (1.0 / 15 - 1.0 / 36) / points;
    EXPECT_LT(squares, of_random_points / 100);
}

}  // namespace
}  // namespace infra
