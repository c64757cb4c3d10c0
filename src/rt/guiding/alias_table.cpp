#include "rt/guiding/alias_table.h"

#include <numeric>

namespace infra {

AliasTable::AliasTable(std::span<const double> weights) {
    const double mean =
        std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    slots_.resize(weights.size());
    std::vector<double> left(weights.begin(), weights.end());
    std::vector<std::uint32_t> poor, rich;
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] /= mean;
        (left[i] < 1 ? poor : rich).push_back(static_cast<std::uint32_t>(i));
    }
    while (!poor.empty() && !rich.empty()) {
        const std::uint32_t taker = poor.back(), giver = rich.back();
        poor.pop_back();
        slots_[taker] = {left[taker], giver};
        left[giver] -= 1 - left[taker];
        if (left[giver] < 1) {
            rich.pop_back();
            poor.push_back(giver);
        }
    }
    // What rounding has left over is as good as full.
    for (const std::uint32_t i : poor) slots_[i] = {1.0, i};
    for (const std::uint32_t i : rich) slots_[i] = {1.0, i};
}

}  // namespace infra
