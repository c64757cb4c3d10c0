// In-band radiance of a black surface over temperature, tabulated for evaluation at every hit.
#pragma once

#include <vector>

namespace infra {

/// Immutable, so that threads share it.
class PlanckCurve {
  public:
    /// Tabulates band_radiance(); 0 <= lo_um < hi_um, as there. throws Error outside those ranges.
    PlanckCurve(double lo_um, double hi_um);

    /// W m^-2 sr^-1 at a temperature in kelvin, > 0.
    ///   method    ln L over ln T, cubic Hermite with the exact slopes, 20..6500 K; computed outside of it
    ///   accuracy  1e-8 relative to band_radiance()
    double radiance(double temperature) const;

  private:
    struct Node {
        double log_radiance;
        double rise;  ///< over one step of ln T
    };

    double lo_um_, hi_um_;
    std::vector<Node> nodes_;
};

}  // namespace infra
