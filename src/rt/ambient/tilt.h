// Irradiance on a facet that a texture turns, from rays over the surface that it belongs to: how it changes
// as the normal turns, taken as a straight line. The facet's own horizon doesn't enter, and even light falls
// on all facets alike. This is RADIANCE's rotational gradient with -aa 0 (measured: for a lamp low over the
// surface and for one high, turned by 6 to 63 deg), for each channel by itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/vec.h"
#include "rt/ambient/cosine_direction.h"

namespace infra {

class Tilt {
  public:
    /// The turned unit normal's components along the surface's u and v.
    Tilt(double along_u, double along_v)
        : along_u_(along_u), along_v_(along_v), even_share_(std::min(1.0, std::hypot(along_u, along_v))) {}

    /// Direction over the surface for a point of the unit square, neighbours for neighbours. Its density is a
    /// blend of cos / pi with an even one, the more of which the more the normal is turned: weights stay
    /// below 2 towards the horizon.
    Vec3 direction(double x, double y) const {
        const Vec3 d = cosine_direction(x, y);
        const double below2 = d.z * d.z;  // 1 - share of the directions that stand higher
        const double b = even_share_;
        const double cosine = 2 * below2 / (b + std::sqrt(b * b + 4 * (1 - b) * below2));
        const double radius2 = d.x * d.x + d.y * d.y;
        const double widen = radius2 > 0 ? std::sqrt(std::max(0.0, 1 - cosine * cosine) / radius2) : 0.0;
        return {d.x * widen, d.y * widen, cosine};
    }

    /// Density of such directions [1/sr].
    double density(const Vec3& d) const {
        return ((1 - even_share_) * d.z + 0.5 * even_share_) * std::numbers::inv_pi;
    }

    /// What a ray of such a direction counts for; their mean is 1. Negative where the normal turns away.
    double weight(const Vec3& d) const {
        return (d.z + along_u_ * d.x + along_v_ * d.y) / ((1 - even_share_) * d.z + 0.5 * even_share_);
    }

  private:
    double along_u_, along_v_;
    double even_share_;
};

}  // namespace infra
