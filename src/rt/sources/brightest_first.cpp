#include "rt/sources/brightest_first.h"

#include <algorithm>
#include <array>
#include <bit>

namespace infra {
namespace {

constexpr std::size_t few = 256;  // up to here comparing is faster than counting
constexpr int digit_bits = 11, digits = 3;
constexpr std::uint32_t digit_values = 1u << digit_bits;

std::uint32_t digit(const Ranked& entry, int number) {
    return static_cast<std::uint32_t>(entry.key() >> (32 + number * digit_bits)) & (digit_values - 1);
}

}  // namespace

// Floats that are not negative compare like their bits.
Ranked::Ranked(float brightness, std::uint32_t place)
    : key_(std::uint64_t{~std::bit_cast<std::uint32_t>(brightness)} << 32 | place) {}

void sort_brightest_first(std::vector<Ranked>& list, std::vector<Ranked>& spare) {
    if (list.size() <= few) {
        std::sort(list.begin(), list.end(),
                  [](const Ranked& a, const Ranked& b) { return a.key() < b.key(); });
        return;
    }
    std::array<std::array<std::uint32_t, digit_values>, digits> start{};
    for (const Ranked& entry : list)
        for (int d = 0; d < digits; ++d) ++start[d][digit(entry, d)];
    spare.resize(list.size());
    for (int d = 0; d < digits; ++d) {
        std::uint32_t before = 0;
        for (std::uint32_t& count : start[d]) {
            const std::uint32_t next = before + count;
            count = before;
            before = next;
        }
        for (const Ranked& entry : list) spare[start[d][digit(entry, d)]++] = entry;
        list.swap(spare);
    }
}

}  // namespace infra
