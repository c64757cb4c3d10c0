// What a material makes of light sources alone: a reflection that is evaluated but that no rays sample.
#pragma once

#include "common/spectra/spectrum.h"
#include "common/vec.h"

namespace infra {

/// As lobes, built for one hit, in scene coordinates.
class SourceResponse {
  public:
    /// Adds f |cos| [1/sr] for a light source of solid angle omega [sr] around wi. It may be any function of
    /// them, in each channel.
    virtual void add(const Vec3& wi, double omega, Spectrum& result) const = 0;

  protected:
    ~SourceResponse() = default;  // they live in a Scattering and own nothing
};

}  // namespace infra
