// A surface between two clear bodies: what dielectric and interface share.
#pragma once

#include <optional>

#include "rt/materials/scattering.h"
#include "rt/modifier.h"
#include "rt/volume/medium.h"

namespace infra {

class ModifierContext;
struct Interaction;

/// A body of clear matter.
struct ClearBody {
    Spectrum transmissivity;  ///< share of a radiance that one scene unit lets through, 0..1
    double index;             ///< of refraction, above 0

    /// Transmissivity from three arguments on, index from the fourth.
    ///   throws  Error for an index that is not above 0
    ClearBody(const ModifierContext& context, std::size_t first);

    /// The body as rays find it: it absorbs and does not scatter.
    ///   pattern  factor of the transmissivity
    ///   before   what the ray was in, nullptr: nothing
    Medium medium(const Spectrum& pattern, const Medium* before) const;
};

class RefractingSurface final : public Modifier {
  public:
    /// outside: nothing for whatever fills the scene, of index 1.
    RefractingSurface(ModifierContext& context, ClearBody inside, std::optional<ClearBody> outside);

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

  private:
    double index_outside() const { return outside_ ? outside_->index : 1.0; }

    MaterialTraits traits_;
    ClearBody inside_;
    std::optional<ClearBody> outside_;
};

}  // namespace infra
