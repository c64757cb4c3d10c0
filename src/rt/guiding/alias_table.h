// Draws one of N things with given probabilities in constant time.
//
// source: Walker, "An Efficient Method for Generating Discrete Random Variables with General Distributions",
// ACM TOMS 3 (1977); built as in Vose, "A Linear Algorithm", IEEE TSE 17 (1991).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace infra {

class AliasTable {
  public:
    AliasTable() = default;
    /// weights: each finite and >= 0, at least one above 0.
    explicit AliasTable(std::span<const double> weights);

    /// u: uniform in [0, 1); what is left of it after the choice is uniform again.
    std::size_t draw(double& u) const {
        const double scaled = u * static_cast<double>(slots_.size());
        const auto slot = static_cast<std::size_t>(scaled);
        const double rest = scaled - static_cast<double>(slot);
        const Slot& s = slots_[slot];
        if (rest < s.own_share) {
            u = rest / s.own_share;
            return slot;
        }
        u = (rest - s.own_share) / (1 - s.own_share);
        return s.other;
    }

  private:
    struct Slot {
        double own_share;
        std::uint32_t other;
    };
    std::vector<Slot> slots_;
};

}  // namespace infra
