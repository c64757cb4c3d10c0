// The four light materials of lights.cpp, as the set-up of light sources sees them.
#pragma once

#include "rt/compile/modifier_table.h"
#include "rt/sources/light_source.h"

namespace infra {

/// What makes a surface a light source: its radiance, its reach and its beam.
class Emitter {
  public:
    enum class Kind { light, glow, spotlight, illum };

    Emitter(Kind kind, const Spectrum& radiance) : kind_(kind), radiance_(radiance) {}
    Kind kind() const { return kind_; }
    const Spectrum& radiance() const { return radiance_; }
    /// Distance within which a glow gives light; 0: never sampled.
    double reach() const { return reach_; }
    const SpotBeam& beam() const { return beam_; }
    /// False only for an illum with another material to show.
    bool passes_unseen() const { return kind_ == Kind::illum && !has_other_; }

  protected:
    ~Emitter() = default;

    Kind kind_;
    Spectrum radiance_;
    double reach_ = 0;
    SpotBeam beam_;
    bool has_other_ = false;
};

class LightMaterial final : public Modifier, public Emitter {
  public:
    LightMaterial(Kind kind, ModifierContext& context)
        : Modifier(context.name(), context.next),
          Emitter(kind, context.emission(0)),
          traits_{.name = context.name(), .blocks_light = false, .emits = true, .is_light = true} {}

    void set_reach(double reach) { reach_ = reach; }
    void set_beam(const SpotBeam& beam) { beam_ = beam; }
    void set_other(const Modifier* other) {
        other_ = other;
        has_other_ = true;
        if (const Modifier* material = material_of(other)) traits_.relay = material->traits()->relay;
    }

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }
    const Emitter* emitter() const override { return this; }

  private:
    bool counts(const Tracer& tracer, const Interaction& at) const;
    /// Whether it acts as a source for a point at this distance: true but for a glow out of reach.
    bool reaches(double distance) const;

    MaterialTraits traits_;
    const Modifier* other_ = nullptr;
};

}  // namespace infra
