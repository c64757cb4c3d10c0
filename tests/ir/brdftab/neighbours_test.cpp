#include "ir/brdftab/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/random.h"

namespace infra::ir {
namespace {

TEST(NeighbourSearch, FindsWhatBruteForceFinds) {
    RandomStream random(3, 4);
    std::vector<Point3> points;
    for (int n = 0; n < 500; ++n)  // coarse coordinates, so that distances tie
        points.push_back({std::floor(random.uniform() * 8), std::floor(random.uniform() * 8),
                          std::floor(random.uniform() * 8)});
    const NeighbourSearch search(points);
    for (int trial = 0; trial < 100; ++trial) {
        const Point3 at{random.uniform() * 8, std::floor(random.uniform() * 8), random.uniform() * 8};
        std::vector<Neighbour> all;
        for (std::size_t n = 0; n < points.size(); ++n) all.push_back({squared_distance(points[n], at), n});
        std::sort(all.begin(), all.end());
        all.resize(13);
        EXPECT_EQ(search.nearest(at, 13), all);
    }
    EXPECT_EQ(search.nearest({0, 0, 0}, 1000).size(), points.size());
}

}  // namespace
}  // namespace infra::ir
