// Low-discrepancy points of the unit square that are nevertheless random: the first two dimensions of Sobol's
// sequence, scrambled as Owen does it.
//
// Every power of two of them from the start is stratified in all elementary intervals of that size. Each
// point by itself is uniform, so that a mean over any number of them is unbiased, and sequences of different
// seeds are independent of each other. source: Owen, "Scrambled Net Variance for Integrals of Smooth
// Functions" (1997); Laine & Karras, "Stratified Sampling for Stochastic Transparency" (2011), for scrambling
// by a hash; Burley, "Practical Hash-based Owen Scrambling", JCGT 9 (2020), for shuffling the order so that
// dimensions can be padded.
#pragma once

#include <array>
#include <cstdint>

namespace infra {

/// Scrambles its arguments into a seed.
std::uint64_t seed_of(std::uint64_t a, std::uint64_t b);

/// Point `index` of the sequence that `seed` names, in [0, 1) x [0, 1).
std::array<double, 2> owen_sobol_point(std::uint32_t index, std::uint64_t seed);

}  // namespace infra
