// How many rays were traced, by how they came about.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

#include "rt/ray.h"

namespace infra {

struct RayCounts {
    static constexpr int kinds = std::bit_width(unsigned{through_lobe});

    std::array<std::uint64_t, kinds> of{};  ///< by the number of RayKind's bit

    void count(std::uint16_t kind) { ++of[static_cast<std::size_t>(std::countr_zero(kind))]; }
    std::uint64_t of_kinds(unsigned wanted) const {
        std::uint64_t sum = 0;
        for (int i = 0; i < kinds; ++i) sum += wanted >> i & 1 ? of[static_cast<std::size_t>(i)] : 0;
        return sum;
    }
    std::uint64_t total() const { return std::accumulate(of.begin(), of.end(), std::uint64_t{0}); }
    void add(const RayCounts& more) {
        for (std::size_t i = 0; i < of.size(); ++i) of[i] += more.of[i];
    }
};

}  // namespace infra
