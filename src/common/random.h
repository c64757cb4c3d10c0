// Random numbers: one independent, reproducible stream for each primary ray.
//
// A stream is named by (seed, index): pixel or input ray number. Whatever thread traces the ray draws the
// same numbers, so a picture does not depend on the number of threads or on the order in which they work.
// source: Blackman & Vigna, "Scrambled linear pseudorandom number generators" (xoroshiro128+), seeded by
// SplitMix64.
//
// Some of the numbers may be chosen: whoever has better ones for the next two draws puts them first.
#pragma once

#include <array>
#include <cstdint>

namespace infra {

class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint64_t index) { begin(seed, index); }

    /// Goes to the start of another stream.
    void begin(std::uint64_t seed, std::uint64_t index) {
        std::uint64_t x = seed * 0x9e3779b97f4a7c15u ^ mix(index + 0x632be59bd9b4e019u);
        a_ = mix(x += 0x9e3779b97f4a7c15u);
        b_ = mix(x + 0x9e3779b97f4a7c15u);
        if ((a_ | b_) == 0) a_ = 1;
        chosen_ = 0;
    }

    /// Uniform in [0, 1), multiples of 2^-53.
    double uniform() {
        if (chosen_ > 0) [[unlikely]]
            return choice_[2 - chosen_--];
        const std::uint64_t result = a_ + b_;
        const std::uint64_t t = b_ ^ a_;
        a_ = rotate(a_, 24) ^ t ^ (t << 16);
        b_ = rotate(t, 37);
        return static_cast<double>(result >> 11) * 0x1p-53;
    }

    /// The next two numbers, each in [0, 1).
    void choose(const std::array<double, 2>& numbers) {
        choice_ = numbers;
        chosen_ = 2;
    }
    /// None of those that are left.
    void choose_no_more() { chosen_ = 0; }

  private:
    static std::uint64_t rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    std::uint64_t a_, b_;
    std::array<double, 2> choice_{};
    unsigned chosen_ = 0;  ///< how many of them are left
};

}  // namespace infra
