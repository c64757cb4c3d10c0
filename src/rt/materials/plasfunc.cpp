// plasfunc, metfunc: plastic and metal whose highlights a function gives.
//
//     mod plasfunc id
//     2+ refl funcfile transform
//     0
//     4+ red green blue specularity A5 ..
//
// refl(x,y,z,omega) is the BRDF [1/sr] of the specular part for light from the direction x y z out of a solid
// angle omega [sr]; it is multiplied by the specularity, and for metfunc by the colour. The function sees,
// besides what every function does, NxP NyP NzP, RdotP and CrP CgP CbP (functions.h), and A1.. from the red
// argument on. What is left, 1 - specularity, is diffuse and coloured. Only light sources are seen in the
// specular part: for indirect light it counts as diffuse. Both sides are alike. source: RADIANCE reference
// manual, "Materials".
#include "rt/compile/modifier_table.h"
#include "rt/materials/programmed_material.h"

namespace infra {
namespace {

std::unique_ptr<Modifier> make(ModifierContext& context, bool metallic) {
    return std::make_unique<ProgrammedMaterial>(context, reflecting_shares(context, metallic),
                                                ProgrammedValue::Kind::function);
}

}  // namespace

std::unique_ptr<Modifier> make_plasfunc(ModifierContext& context) { return make(context, false); }
std::unique_ptr<Modifier> make_metfunc(ModifierContext& context) { return make(context, true); }

}  // namespace infra
