// How much energy Ward's lobe loses when it is sampled by several rays a hit.
#pragma once

#include <mutex>
#include <vector>

namespace infra {

/// Mean weight of the rays of a rough reflection. Shared by all threads; its table is made when it is first
/// asked for, which only thermal surfaces do.
class WardEnergy {
  public:
    /// roughness: RMS slope, > 0.
    explicit WardEnergy(double roughness) : roughness_(roughness) {}

    /// Of `count` > 1 rays to a viewer at this cosine, 0..1: of all that Tracer::trace_lobe adds up and
    /// divides by its draws, so that count enters (an inverse binomial mean has a bias).
    ///   accuracy  1e-3: quadrature of 160 x 80 slopes at 65 angles, linear between these
    double mean_weight(double cosine, int count) const;

  private:
    struct Node {
        double accepted;  ///< probability that a draw leaves the surface
        double weight;    ///< mean weight of those that do
    };
    Node at_angle(double angle) const;

    double roughness_;
    mutable std::once_flag made_;
    mutable std::vector<Node> nodes_;  ///< by angle, 0 .. 90 deg
};

}  // namespace infra
