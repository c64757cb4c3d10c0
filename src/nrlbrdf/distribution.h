// The table's own distribution: directions wi drawn with a density exactly proportional to lobe *
// cos(theta_i).
//
// A trilinear table is a sum over its nodes of value * hat(theta_i) * hat(phi) * hat(theta_r). For a given
// viewer that is a mixture of products of one-dimensional densities: choose one of the two neighbouring
// viewing angles, then a node (theta_i, phi) by its cumulated energy, then theta within hat * cos * sin and
// phi within its hat. Nothing is approximated, so every sample has the same weight, lobe_reflectance_dh.
#pragma once

#include <memory>
#include <vector>

#include "nrlbrdf/table.h"

namespace infra {

/// Immutable; needs as much memory as the table's values. Build one per table and share it.
class TableDistribution {
  public:
    explicit TableDistribution(std::shared_ptr<const BrdfTable> table);

    const BrdfTable& table() const { return *table_; }

    /// A direction for a viewer above the surface whose lobe is not zero; u in [0,1)^3.
    Vec3 sample(const Vec3& wo, double u1, double u2, double u3) const;

  private:
    double sample_theta(int i, double u) const;

    std::shared_ptr<const BrdfTable> table_;
    std::vector<double> lower_half_,
        upper_half_;               // per theta_i: mass of hat * cos * sin below and above the node
    std::vector<double> row_cdf_;  // per (theta_r, theta_i): up to and with theta_i, last is 1
    std::vector<float> phi_cdf_;   // per (theta_r, theta_i, phi): likewise over phi
};

}  // namespace infra
