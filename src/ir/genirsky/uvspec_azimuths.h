// The azimuths of uvspec's radiances.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ir/genirsky/placed_numbers.h"

namespace infra::ir {

/// phi of the input file, degrees. A phi that stands for the direction of one before it, as 360 after 0, may
/// close the circle: its radiances must be the same, and are left out.
class UvspecAzimuths {
  public:
    explicit UvspecAzimuths(const std::vector<double>& phi = {});

    /// Radiances that the file has for each umu.
    std::size_t columns() const { return column_of_.size(); }
    /// Every azimuth once; without phi the mean over azimuth alone, nothing.
    const std::vector<std::optional<double>>& directions() const { return directions_; }
    /// The radiances of one umu, one for each of directions().
    ///   shape   numbers: columns()
    ///   throws  Error with line and column where one that closes the circle differs
    std::vector<PlacedNumber> distinct(std::span<const PlacedNumber> numbers, const NumberText& text) const;

  private:
    std::vector<std::optional<double>> directions_;
    std::vector<std::size_t> column_of_;  ///< among directions_
};

}  // namespace infra::ir
