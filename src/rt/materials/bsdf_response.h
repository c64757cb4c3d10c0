// What light sources bring by way of a BSDF beyond its Lambertian parts.
#pragma once

#include "rt/lobes/source_response.h"
#include "rt/materials/bsdf_hit.h"

namespace infra {

/// The mean over the patch that the viewer is seen in, so that the edges of patches do not show: `samples`
/// places in it for each light source.
class BsdfResponse final : public SourceResponse {
  public:
    enum class Way { both, reflection, transmission };

    /// samples: >= 1. The hit must outlive this.
    BsdfResponse(const BsdfHit& hit, int samples, Way way = Way::both)
        : hit_(hit), samples_(samples), way_(way) {}

    void add(const Vec3& wi, double omega, Spectrum& result) const override;

  private:
    void add_table(const ScatterTable& table, const Vec3& to_source, float scale, Spectrum& result) const;
    bool looks_through(const Vec3& to_source, double omega) const;

    const BsdfHit& hit_;
    int samples_;
    Way way_;
};

}  // namespace infra
