#include "common/owen_sobol.h"

namespace infra {
namespace {

std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    return __builtin_bswap32(x);
}

/// A permutation in which no bit depends on a higher one. source: constants of Vegdahl's search
/// ("Building a better LK hash", 2021).
std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Flips each bit by chance, a chance of its own for all that the higher bits may be.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    return reversed_bits(laine_karras(reversed_bits(x), seed));
}

/// Sobol's second dimension, whose generator matrix is Pascal's triangle modulo 2.
std::uint32_t second_dimension(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1u << 31; index != 0; index >>= 1, column ^= column >> 1)
        if (index & 1) result ^= column;
    return result;
}

double fraction(std::uint32_t x) { return x * 0x1p-32; }

}  // namespace

std::uint64_t seed_of(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a * 0x9e3779b97f4a7c15u + b;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::array<double, 2> owen_sobol_point(std::uint32_t index, std::uint64_t seed) {
    const std::uint64_t other = seed_of(seed, 1);
    const std::uint32_t place = scrambled(index, static_cast<std::uint32_t>(other));  // another order
    return {fraction(scrambled(reversed_bits(place), static_cast<std::uint32_t>(seed))),
            fraction(scrambled(second_dimension(place), static_cast<std::uint32_t>(seed >> 32)))};
}

}  // namespace infra
