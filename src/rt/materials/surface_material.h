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

  protected:
    /// What tells a material's two sides apart (BRTDfunc, WGMDfunc).
    struct Sides {
        bool back_may_hide = true;    ///< -bv 0 makes the back invisible
        bool turns_to_viewer = true;  ///< the surface is reported as facing the viewer (rtrace -on)
    };
    void set_sides(const Sides& sides) { sides_ = sides; }
    /// For what can be seen through but lets no light source shine through (trans2).
    void block_light() { traits_.blocks_light = true; }

  private:
    MaterialTraits traits_;
    Sides sides_;
};

}  // namespace infra
