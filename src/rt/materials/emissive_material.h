// emissive: a surface that emits and reflects; see emissive.cpp.
#pragma once

#include <memory>

#include "rt/materials/light_material.h"

namespace infra {

class EmissiveMaterial final : public Modifier, public Emitter {
  public:
    /// reflecting: chain of the material that reflects, nullptr for a black emitter. reach: as glow's maxrad.
    EmissiveMaterial(std::string_view name, const Modifier* next, const Spectrum& radiance, double reach,
                     const Modifier* reflecting);
    /// The same for a material that nothing else refers to.
    EmissiveMaterial(std::string_view name, const Modifier* next, const Spectrum& radiance, double reach,
                     std::unique_ptr<Modifier> reflecting);

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }
    const Emitter* emitter() const override { return this; }

  private:
    bool counts(const Tracer& tracer, const Interaction& at) const;
    void add_emission(Tracer& tracer, Interaction& at) const;

    MaterialTraits traits_;
    std::unique_ptr<Modifier> owned_;
    const Modifier* reflecting_;
};

}  // namespace infra
