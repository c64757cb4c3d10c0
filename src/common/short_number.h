// The numbers of which large scenes are full, read eight characters at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace infra {

/// Reads a number at the beginning of `text` that a blank or another control character follows: an optional
/// '-', then up to 7 digits, one of which may be a point instead. To the nearest double: it is the
/// quotient of two integers that a double holds exactly (W. D. Clinger, "How to Read Floating Point Numbers
/// Accurately", PLDI 1990).
///   returns  how many characters it takes; 0, and `value` as it was, for anything else and at the end of
///   `text`
inline std::size_t parse_short_number(std::string_view text, double& value) {
    static_assert(std::endian::native == std::endian::little);
    constexpr std::uint64_t each = 0x0101010101010101, tops = 0x80 * each;
    static constexpr double power_of_ten[8] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
    if (text.size() < 9) return 0;
    const bool negative = text[0] == '-';
    std::uint64_t word;
    std::memcpy(&word, text.data() + negative, 8);

    const std::uint64_t controls = (word - ('!' * each)) & ~word & tops;
    const int size = std::countr_zero(controls) >> 3;  // 8 if there is none
    if (size == 0 || size == 8) return 0;
    word <<= 8 * (8 - size);

    // Closes the gap that the point leaves, the last character stays last.
    const std::uint64_t other_than_point = word ^ ('.' * each);
    const std::uint64_t points = (other_than_point - each) & ~other_than_point & tops;
    int fraction = 0, digits = size;
    if (points != 0) {
        const int before = std::countr_zero(points) >> 3;
        const std::uint64_t whole = word & ~(~std::uint64_t(0) << 8 * before);
        word = (word >> 8 * before >> 8 << 8 * before << 8) | whole << 8;
        fraction = 7 - before;
        if (--digits == 0) return 0;
    }
    word ^= ('0' * each) & ~std::uint64_t(0) << 8 * (8 - digits);
    if (((word + 0x76 * each) | word) & tops) return 0;  // no digits

    word =
        10 * word + (word >> 8);  // in every other byte two digits, then four in every other pair, then eight
    constexpr std::uint64_t bytes = 0x000000ff000000ff;
    word = ((word & bytes) * (100 + (std::uint64_t(1000000) << 32)) +
            (word >> 16 & bytes) * (1 + (std::uint64_t(10000) << 32))) >>
           32;
    const double magnitude = double(word) / power_of_ten[fraction];
    value = negative ? -magnitude : magnitude;
    return static_cast<std::size_t>(size) + negative;
}

}  // namespace infra
