// What plastic, metal and trans have in common: a Lambertian part, a mirror or Gaussian reflection, a
// transmission.
#pragma once

#include <memory>

#include "rt/lobes/ward_energy.h"
#include "rt/materials/surface_material.h"

namespace infra {

struct WardParameters {
    Spectrum color;
    double specularity = 0;           ///< reflected specular fraction at normal incidence
    double roughness = 0;             ///< RMS facet slope; 0: a mirror
    double transmissivity = 0;        ///< fraction of what is not reflected specularly that goes through
    double transmitted_specular = 0;  ///< fraction of that which goes straight through
    bool metallic = false;            ///< the reflection takes the material's colour
    std::shared_ptr<const WardEnergy> energy;  ///< of rough ones, where -ss asks for several rays
};

class ModifierContext;

/// Plastic, metal or trans with these parameters.
std::unique_ptr<Modifier> make_ward_material(ModifierContext& context, WardParameters parameters,
                                             bool transparent);

class WardMaterial final : public SurfaceMaterial {
  public:
    WardMaterial(std::string_view name, const Modifier* next, const WardParameters& parameters,
                 bool transparent)
        : SurfaceMaterial(name, next, transparent), p_(parameters) {}

    void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const override;

  private:
    WardParameters p_;
};

}  // namespace infra
