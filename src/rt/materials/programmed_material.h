// What plasfunc, metfunc, transfunc and their versions with data have in common: a Lambertian part, and
// reflection and transmission that a function gives for light sources.
#pragma once

#include "rt/functions/programmed_value.h"
#include "rt/materials/surface_material.h"

namespace infra {

class Channels;

/// The variables of these materials' functions at a hit whose shading normal is out.normal.
MaterialVariables material_variables(const Channels& channels, const Interaction& at, const Vec3& normal,
                                     const Spectrum& color);

struct ProgrammedShares {
    Spectrum color;
    double reflected = 0;             ///< factor of the function on this side
    double transmitted = 0;           ///< fraction of all light that goes through
    double transmitted_specular = 0;  ///< factor of the function on the other side
    bool metallic = false;            ///< the reflection takes the colour; transmission always does
};

class ProgrammedMaterial final : public SurfaceMaterial {
  public:
    ProgrammedMaterial(ModifierContext& context, const ProgrammedShares& shares, ProgrammedValue::Kind kind);

    void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const override;

  private:
    ProgrammedShares p_;
    ProgrammedValue value_;
};

/// Arguments red green blue specularity, of plasfunc and metfunc, plasdata and metdata.
ProgrammedShares reflecting_shares(const ModifierContext& context, bool metallic);

/// Arguments red green blue rspec trans tspec, of transfunc and transdata.
ProgrammedShares transmitting_shares(const ModifierContext& context);

}  // namespace infra
