// How much energy Ward's lobe loses when it is sampled by several rays a hit.
#pragma once

#include <mutex>
#include <vector>

#include "common/vec.h"

namespace infra {

/// RMS slopes of a surface's facets along two orthogonal directions, the same for most materials.
struct FacetSlopes {
    double u = 0, v = 0;

    bool isotropic() const { return u == v; }
    auto operator<=>(const FacetSlopes&) const = default;
};

/// Mean weight of the rays of a rough reflection. Shared by all threads; its table is made when it is first
/// asked for, which only thermal surfaces do.
class WardEnergy {
  public:
    /// roughness: both slopes > 0.
    explicit WardEnergy(const FacetSlopes& roughness) : roughness_(roughness) {}

    /// Of `count` > 1 rays to a viewer in this direction, given along u, v and the normal: of all that
    /// Tracer::trace_lobe adds up and divides by its draws, so that count enters (an inverse binomial mean
    /// has a bias).
    ///   accuracy  1e-3: quadrature of 25 600 slopes at 65 angles from the normal and, for two roughnesses,
    ///             17 around it, linear between these
    double mean_weight(const Vec3& to_viewer, int count) const;

  private:
    struct Node {
        double accepted;  ///< probability that a draw leaves the surface
        double weight;    ///< mean weight of those that do
    };
    Node at_angles(double angle, double azimuth) const;
    Node between(double angle, double azimuth) const;
    void make_nodes() const;

    FacetSlopes roughness_;
    mutable std::once_flag made_;
    mutable std::vector<Node> nodes_;  ///< by azimuth, 0 .. 90 deg, and angle, 0 .. 90 deg
};

}  // namespace infra
