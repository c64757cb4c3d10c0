#include "common/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "support/chi_square.h"

namespace infra {
namespace {

// Probability that pairs (x, y) as even as these, or less, come from a uniform square.
template <class Pair>
double evenness(int count, const Pair& next) {
    constexpr int cells = 16;
    std::vector<double> hits(cells * cells);
    for (int n = 0; n < count; ++n) {
        const auto [x, y] = next(n);
        ++hits[static_cast<std::size_t>(static_cast<int>(x * cells) * cells + static_cast<int>(y * cells))];
    }
    const double expected = static_cast<double>(count) / (cells * cells);
    double statistic = 0;
    for (const double h : hits) statistic += (h - expected) * (h - expected) / expected;
    return test::chi_square_p(statistic, cells * cells - 1);
}

constexpr int pairs = 200'000;
using Pair = std::pair<double, double>;

TEST(RandomStream, RepeatsForTheSameSeedAndIndex) {
    RandomStream a(3, 17), b(3, 17);
    for (int n = 0; n < 1000; ++n) EXPECT_EQ(a.uniform(), b.uniform());
}

TEST(RandomStream, StaysInTheHalfOpenUnitInterval) {
    RandomStream random(1, 1);
    double sum = 0, sum2 = 0;
    for (int n = 0; n < pairs; ++n) {
        const double u = random.uniform();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        sum2 += u * u;
    }
    EXPECT_NEAR(sum / pairs, 1.0 / 2, 4 * std::sqrt(1.0 / 12 / pairs));
    EXPECT_NEAR(sum2 / pairs, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / pairs));
}

TEST(RandomStream, SuccessiveNumbersAreEven) {
    RandomStream random(5, 9);
    EXPECT_GT(evenness(pairs, [&](int) { return Pair{random.uniform(), random.uniform()}; }), 1e-4);
}

// Pixels are streams of successive indices: their first and their later numbers must not be alike.
TEST(RandomStream, StreamsOfSuccessiveIndicesAreIndependent) {
    for (const std::uint64_t seed : {0u, 1u, 12345u})
        for (const int skip : {0, 1, 7}) {
            const auto value = [&](int index) {
                RandomStream stream(seed, static_cast<std::uint64_t>(index));
                for (int n = 0; n < skip; ++n) stream.uniform();
                return stream.uniform();
            };
            EXPECT_GT(evenness(pairs,
                               [&](int n) {
                                   return Pair{value(n), value(n + 1)};
                               }),
                      1e-4)
                << seed << ' ' << skip;
        }
}

TEST(RandomStream, StreamsOfSuccessiveSeedsAreIndependent) {
    const auto value = [](int seed) { return RandomStream(static_cast<std::uint64_t>(seed), 4).uniform(); };
    EXPECT_GT(evenness(pairs, [&](int n) { return Pair{value(n), value(n + 1)}; }), 1e-4);
}

TEST(RandomStream, NoTwoStreamsBeginAlike) {
    std::set<double> first;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (std::uint64_t index = 0; index < 1000; ++index)
            first.insert(RandomStream(seed, index).uniform());
    EXPECT_EQ(first.size(), 100'000u);
}

}  // namespace
}  // namespace infra
