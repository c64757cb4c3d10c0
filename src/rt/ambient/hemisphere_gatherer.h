// The irradiance of one place for the cache: a hemisphere of rays, and how far what they have seen may be
// used.
//
// source: numbers and weights of rays, limits of radii as RADIANCE 6.1; Ward & Heckbert, "Irradiance
// Gradients" (1992) for the derivative with the normal; hemisphere_mesh.h for those with the place.
#pragma once

#include <optional>

#include "rt/ambient/irradiance_cache.h"
#include "rt/guiding/guided_share.h"
#include "rt/scratch.h"

namespace infra {

class HemisphereGatherer {
  public:
    /// Rays of a value have this share of the weight of the hit that it is made for: others will use it.
    static constexpr double assumed_reflectance = 0.5;

    enum class Outcome {
        nothing,     ///< no ray was heavy enough to be traced
        value_only,  ///< some were not: radiance is good for this hit alone
        complete,
    };

    /// kind: reflected_ambient or through_ambient. `at` and `tracer` outlive this.
    HemisphereGatherer(Tracer& tracer, Interaction& at, const IrradiancePlace& place, std::uint16_t kind);
    HemisphereGatherer(const HemisphereGatherer&) = delete;
    HemisphereGatherer& operator=(const HemisphereGatherer&) = delete;
    ~HemisphereGatherer();

    /// False if none of the rays would be traced: they are too light, or have too many reflections behind
    /// them.
    bool may_trace();
    /// Draws from a random stream of the place, not from that of the ray that asks. The hit must be heavy
    /// enough for roulette to spare all rays.
    Outcome gather(const CacheLimits& limits, IrradianceValue& value);

  private:
    bool trace(int cell, double x, double y, bool first, Spectrum& radiance);
    int trace_grid();
    void trace_more();
    void trace_guided(Spectrum& sum);
    void describe_change(const CacheLimits& limits, IrradianceValue& value);
    void turn_gradient(IrradianceValue& value) const;

    Tracer& tracer_;
    Interaction& at_;
    const IrradiancePlace& place_;
    std::uint16_t kind_;
    Vec3 u_, v_;
    double weight_;
    int divisions_;
    std::optional<GuidedShare> guided_;
    HemisphereView view_;
    RandomStream others_;  // the ray's random stream, until the end
    bool spreads_;         // and whether it is spread over a pixel's samples
};

}  // namespace infra
