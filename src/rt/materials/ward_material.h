// What plastic, metal and trans have in common, and plastic2, metal2 and trans2 with them: a Lambertian part,
// a mirror or Gaussian reflection, a transmission.
#pragma once

#include <memory>

#include "rt/lobes/ward_energy.h"
#include "rt/materials/orientation.h"
#include "rt/materials/surface_material.h"

namespace infra {

struct WardFacets {
    FacetSlopes roughness;                     ///< 0: a mirror, of a material without orientation
    std::shared_ptr<const WardEnergy> energy;  ///< of rough ones, where -ss asks for several rays
};

/// What makes a surface rougher one way than the other.
struct WardOrientation {
    Orientation direction;
    WardFacets all_around;  ///< where it has none: the slopes' root mean square
};

struct WardParameters {
    Spectrum color;
    double specularity = 0;  ///< reflected specular fraction at normal incidence
    WardFacets facets;
    double transmissivity = 0;        ///< fraction of what is not reflected specularly that goes through
    double transmitted_specular = 0;  ///< fraction of that which goes straight through
    bool metallic = false;            ///< the reflection takes the material's colour
};

class ModifierContext;
struct WardSetting;

/// Plastic, metal or trans with these parameters. Their roughness is the same all around.
std::unique_ptr<Modifier> make_ward_material(ModifierContext& context, WardParameters parameters,
                                             bool transparent);

/// Plastic2, metal2 or trans2: rough, along the directions that the string arguments give.
///   throws  Error for a roughness of 0
std::unique_ptr<Modifier> make_oriented_ward_material(ModifierContext& context, WardParameters parameters,
                                                      bool transparent);

class WardMaterial final : public SurfaceMaterial {
  public:
    /// orientation: nullptr if the roughness is the same all around.
    WardMaterial(std::string_view name, const Modifier* next, const WardParameters& parameters,
                 bool transparent, std::unique_ptr<const WardOrientation> orientation = nullptr);

    void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const override;

  private:
    void set_facets(Tracer& tracer, const Interaction& at, const Vec3& normal, WardSetting& setting) const;
    Vec3 bent_direction(Tracer& tracer, const Interaction& at, bool shadow) const;

    WardParameters p_;
    std::unique_ptr<const WardOrientation> orientation_;
    bool smooth_;
};

}  // namespace infra
