// Values on a rectangular grid, found among points.
#pragma once

#include <optional>
#include <vector>

#include "ir/genirsky/sea_plane.h"

namespace infra::ir {

/// Spacing need not be even.
class SeaGrid {
  public:
    /// Nothing unless every x occurs once with every y, with at least two of each. shape: points in any
    /// order.
    static std::optional<SeaGrid> find(const std::vector<SeaPoint>& points);

    /// Bilinear; nothing outside the grid.
    std::optional<double> at(double x, double y) const;

  private:
    std::vector<double> x_, y_;
    std::vector<double> values_;  ///< y by y
};

}  // namespace infra::ir
