// dielectric: the surface of a body of clear matter, normals outward.
//
//     mod dielectric id
//     0
//     0
//     5 red green blue refractive_index hartmann
//
// The colour is the transmissivity of one scene unit within the body; patterns multiply it. The index of
// refraction is that argument plus hartmann / 500 nm: one index for all wavelengths, as RADIANCE 6.1 is built
// (colours do not part). Radiance within the body is the square of the index times as large as outside.
// source: RADIANCE reference manual, "Materials"; Born & Wolf, Principles of Optics, 1.5.
#include "rt/compile/modifier_table.h"
#include "rt/materials/refracting_surface.h"

namespace infra {
namespace {

constexpr double mean_wavelength_nm = 500;

}  // namespace

std::unique_ptr<Modifier> make_dielectric(ModifierContext& context) {
    ClearBody inside(context, 0);
    inside.index += context.reals()[4] / mean_wavelength_nm;
    if (!(inside.index > 0)) throw context.error("refractive index with its dispersion must be above 0");
    return std::make_unique<RefractingSurface>(context, std::move(inside), std::nullopt);
}

}  // namespace infra
