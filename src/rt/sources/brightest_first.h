// Puts many light sources in the order of what they may add.
#pragma once

#include <cstdint>
#include <vector>

namespace infra {

/// A place in a list, with what it is sorted by.
class Ranked {
  public:
    Ranked() = default;
    /// brightness: 0 or above
    Ranked(float brightness, std::uint32_t place);

    std::uint32_t place() const { return static_cast<std::uint32_t>(key_); }
    /// The brightest have the least; equal ones in the order of their places.
    std::uint64_t key() const { return key_; }

  private:
    std::uint64_t key_ = 0;
};

/// Sorts, the brightest first. The places must count up in the list as it is given.
///   spare  memory that is kept for the next call
void sort_brightest_first(std::vector<Ranked>& list, std::vector<Ranked>& spare);

}  // namespace infra
