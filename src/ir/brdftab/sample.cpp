#include "ir/brdftab/sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;

/// Angles that differ by less than this are one: 1e-6 degrees.
constexpr double angle_resolution = 1e-6 * pi / 180;

using Geometry = std::array<long long, 3>;

Geometry geometry_key(const BrdfSample& s) {
    return {std::llround(s.theta_i / angle_resolution), std::llround(s.theta_r / angle_resolution),
            std::llround(s.phi / angle_resolution)};
}

BrdfSample folded(BrdfSample s) {
    s.phi = std::abs(std::remainder(s.phi, 2 * pi));
    if (s.theta_i < angle_resolution || s.theta_r < angle_resolution) s.phi = 0;
    return s;
}

}  // namespace

std::vector<BrdfSample> distinct_samples(const std::vector<BrdfSample>& samples, bool with_reciprocal) {
    struct Sum {
        BrdfSample first;
        double total = 0;
        int count = 0;
    };
    std::map<Geometry, Sum> sums;
    const auto add = [&sums](const BrdfSample& s) {
        Sum& sum = sums[geometry_key(s)];
        if (sum.count == 0) sum.first = s;
        sum.total += s.f;
        ++sum.count;
    };
    for (const BrdfSample& sample : samples) {
        BrdfSample s = folded(sample);
        add(s);
        if (!with_reciprocal) continue;
        std::swap(s.theta_i, s.theta_r);
        if (geometry_key(s) != geometry_key(folded(sample))) add(s);
    }
    std::vector<BrdfSample> distinct;
    for (const auto& [key, sum] : sums) {
        distinct.push_back(sum.first);
        distinct.back().f = sum.total / sum.count;
    }
    return distinct;
}

}  // namespace infra::ir
