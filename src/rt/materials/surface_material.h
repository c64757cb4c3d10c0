// Base of every material that reflects or transmits: it answers scatter(), the tracer does the rest.
#pragma once

#include "rt/materials/scattering.h"
#include "rt/modifier.h"
#include "rt/ray.h"

namespace infra {

class SurfaceMaterial : public Modifier {
  public:
    SurfaceMaterial(std::string_view name, const Modifier* next, bool transparent)
        : Modifier(name, next),
          traits_{.name = name, .transparent = transparent, .blocks_light = !transparent} {}

    /// Fills `out` for the hit `at`: its normal faces the viewer, its patterns and textures have been applied
    /// and out.normal is the normal with textures. shadow: only what a shadow ray passes through is wanted.
    /// The tracer answers for settings and evaluates functions; no ray may be traced here.
    virtual void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const = 0;

    bool shade(Tracer& tracer, Interaction& at) const final;
    const MaterialTraits* traits() const final { return &traits_; }

  private:
    MaterialTraits traits_;
};

}  // namespace infra
