// Importance sampling of a table's lobe: the table's own distribution mixed with a Gaussian probe around the
// mirror direction, combined by the one-sample balance heuristic. alpha changes the noise only, never the
// mean. Conventions as in table.h.
#pragma once

#include <memory>

#include "nrlbrdf/distribution.h"

namespace infra {

/// weight = lobe * cos(theta_i) / pdf. Weight and pdf are 0 for a sample lost below the surface: it counts as
/// a ray that brings nothing.
struct LobeSample {
    Vec3 wi{0, 0, 1};
    double weight = 0;
    double pdf = 0;  ///< [1/sr]
};

/// Share of the samples that the Gaussian probe takes. The table's own distribution is exact: alone it gives
/// every sample the same weight, so under smooth light the probe only adds noise, at most sqrt(share / (1 -
/// share)) of the mean weight. It pays where the light has a peak near the mirror direction that is narrower
/// than the lobe. Relative standard deviation of weight * light, viewer at 52 deg, alpha 0.05, the tables of
/// tests/nrlbrdf/tables.h; "disk" is light of 1 with a disk of 1000 of 2 deg half-angle around the mirror
/// direction:
///     share         0              1/16           1/8            1/4            1/2
///     light         even   disk    even   disk    even   disk    even   disk    even   disk
///     gaussian      0      9.5     0.15   6.4     0.27   5.1     0.46   3.9     0.86   2.8
///     phong         0     11.0     0.17   6.5     0.29   5.1     0.49   3.8     0.89   2.7
///     lopsided      0     15.4     0.22   5.5     0.34   4.0     0.54   2.8     0.96   1.9
/// Infrared skies and seas are smooth and small sources are sampled directly: a small share, then.
inline constexpr double probe_share = 0.0625;

class LobeSampler {
  public:
    /// alpha: RMS slope of the Gaussian probe, in (0, 1]. Several samplers may share one distribution.
    LobeSampler(std::shared_ptr<const TableDistribution> distribution, double alpha);

    const BrdfTable& table() const { return distribution_->table(); }

    /// A direction for the viewer wo and uniforms in [0,1). Weight 0 when the viewer is below the surface or
    /// sees no lobe. The mean of the weight is lobe_reflectance_dh(wo.z).
    LobeSample sample(const Vec3& wo, double u1, double u2, double u3) const;

    /// Density of sample() [1/sr]; its integral is 1 less what the probe loses below the surface.
    double pdf(const Vec3& wo, const Vec3& wi) const;

  private:
    LobeSample evaluate(const Vec3& wo, const Vec3& wi, double reflectance) const;

    std::shared_ptr<const TableDistribution> distribution_;
    double alpha_;
};

}  // namespace infra
