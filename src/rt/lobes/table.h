// The lobe of a tabulated BRDF: what is left of it above its Lambertian part.
#pragma once

#include <algorithm>

#include "nrlbrdf/sampler.h"
#include "nrlbrdf/spectral_table.h"
#include "rt/lobes/lobe.h"
#include "rt/ray.h"
#include "rt/settings.h"

namespace infra {

class TableLobe final : public Lobe {
  public:
    /// coefficient: color times each channel's directional-hemispherical reflectance of the lobe for this
    /// viewer; albedo: that of the sampler's table, > 0. spectral: the tables of the channels, nullptr when
    /// the sampler's is that of all. normal carries the textures; no sample goes below surface_normal.
    TableLobe(const Spectrum& lobe_coefficient, double albedo, const LobeSampler& sampler,
              const SpectralTable* spectral, const Vec3& normal, const Vec3& surface_normal,
              const Vec3& to_viewer, double samples)
        : Lobe(reflected_lobe, lobe_coefficient),
          sampler_(sampler),
          spectral_(spectral),
          normal_(normal),
          surface_normal_(surface_normal),
          inverse_albedo_(1.0 / albedo),
          samples_(samples) {
        colored = spectral != nullptr;
        make_frame(normal, u_, v_);
        wo_ = to_local(to_viewer);
    }

    double eval(const Vec3& wi, double) const override {
        const Vec3 local = to_local(wi);
        if (local.z <= 0 || dot(wi, surface_normal_) <= same_place) return 0;
        return sampler_.table().eval_lobe(wo_, local) * local.z * inverse_albedo_;
    }

    /// The first number chooses between probe and table, and the angle: its strata give each its share.
    LobeDraw sample(RandomStream& random, int index, int count) const override {
        const double u1 = (index + random.uniform()) / count;
        const double u2 = random.uniform(), u3 = random.uniform();
        const LobeSample drawn = sampler_.sample(wo_, u1, u2, u3);
        const Vec3 wi = u_ * drawn.wi.x + v_ * drawn.wi.y + normal_ * drawn.wi.z;
        const double weight = drawn.weight * inverse_albedo_;
        return dot(wi, surface_normal_) > same_place ? LobeDraw{wi, weight} : LobeDraw{wi, 0.0, weight};
    }

    bool exact(int) const override { return true; }

    double pdf(const Vec3& wi) const override { return sampler_.pdf(wo_, to_local(wi)); }

    void tint(const Vec3& wi, Spectrum& factor) const override {
        const Vec3 local = to_local(wi);
        const double mean = sampler_.table().eval_lobe(wo_, local) * inverse_albedo_;
        if (!(mean > 0)) return factor.clear();
        spectral_->normalized_lobe(wo_, local, factor);
        factor *= static_cast<float>(1.0 / mean);
    }

    int sample_count(double ray_weight) const override {
        return std::max(1, static_cast<int>(std::min<double>(samples_ * ray_weight + 0.5, most_samples)));
    }

  private:
    Vec3 to_local(const Vec3& d) const { return {dot(d, u_), dot(d, v_), dot(d, normal_)}; }

    const LobeSampler& sampler_;
    const SpectralTable* spectral_;
    Vec3 normal_, surface_normal_, u_, v_, wo_;
    double inverse_albedo_;
    double samples_;
};

}  // namespace infra
