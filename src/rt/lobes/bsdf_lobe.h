// Rays sampled from a table of a BSDF, its Lambertian part left out.
#pragma once

#include "rt/lobes/lobe.h"
#include "rt/materials/bsdf_hit.h"

namespace infra {

class BsdfLobe final : public Lobe {
  public:
    /// lobe_coefficient: of rays of weight 1; total: the table's for the direction it was decided upon, > 0,
    /// which a sample's own may exceed. The hit must outlive this.
    BsdfLobe(const Spectrum& lobe_coefficient, const BsdfHit& hit, const ScatterTable& table, double total,
             double resolution, bool spares_aperture);

    /// 0: light sources are answered for by a BsdfResponse.
    double eval(const Vec3&, double) const override { return 0; }
    LobeDraw sample(RandomStream& random, int index, int count) const override;
    /// Of a sample for the viewer's direction as it stands, -ss at least 1.
    double pdf(const Vec3& wi) const override;
    /// For the direction that sample() gave last.
    void tint(const Vec3& wi, Spectrum& factor) const override;
    /// Reflectances vary over the patch that samples are drawn for, and an aperture takes part of them: what
    /// a sample brings is taken off the emission with it (LobeDraw::lost), none before.
    double mean_weight(int) const override { return 0; }
    int sample_count(double ray_weight) const override;

  private:
    bool falls_into_aperture(const Vec3& in, const Vec3& out) const;

    const BsdfHit& hit_;
    const ScatterTable& table_;
    double inverse_total_;
    double resolution_;  ///< projected solid angle of a patch [sr]
    bool spares_aperture_;
    mutable Vec3 last_in_{0, 0, 1};
};

}  // namespace infra
