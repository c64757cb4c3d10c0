// A density over all directions, constant within cells of equal solid angle.
#pragma once

#include <span>
#include <vector>

#include "common/vec.h"
#include "rt/guiding/alias_table.h"

namespace infra {

class DirectionMap {
  public:
    /// Cells: `rows` bands of equal height along z, each of `columns` cells around it.
    static constexpr int rows = 256, columns = 512;
    static constexpr int cells = rows * columns;
    static constexpr double cell_size = 12.566370614359172 / cells;  ///< 4 pi over their number [sr]

    DirectionMap() = default;
    /// weights: one a cell, row by row from z = -1; each >= 0, at least one above 0. The density is in
    /// proportion.
    explicit DirectionMap(std::span<const double> weights);

    /// A unit direction for u, v uniform in [0, 1).
    Vec3 sample(double u, double v) const;
    /// Density [1/sr] of sample(); direction: unit.
    double pdf(const Vec3& direction) const { return density_[static_cast<std::size_t>(cell_of(direction))]; }

    /// The unit direction at (u, v), in [0, 1], of a cell.
    static Vec3 direction(int cell, double u, double v);
    static int cell_of(const Vec3& direction);

  private:
    AliasTable choice_;
    std::vector<float> density_;
};

}  // namespace infra
