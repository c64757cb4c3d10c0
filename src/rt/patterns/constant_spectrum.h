// A spectrum that is the same everywhere: what spectrum and specfile come to.
#pragma once

#include "common/spectra/spectrum.h"
#include "rt/modifier.h"
#include "rt/ray.h"

namespace infra {

class ModifierContext;

class ConstantSpectrum final : public Modifier {
  public:
    ConstantSpectrum(std::string_view name, const Modifier* next, const Spectrum& spectrum)
        : Modifier(name, next), spectrum_(spectrum) {}

    bool shade(Tracer&, Interaction& at) const override {
        at.pattern *= spectrum_;
        return false;
    }

  private:
    Spectrum spectrum_;
};

/// Whether spectra between these wavelengths [nm] say anything about the channels that are rendered; if not
/// the user is told, for they count as 0 there.
bool reaches_channels(ModifierContext& context, double nm_a, double nm_b);

}  // namespace infra
