// trans: a thin translucent sheet, a plastic that lets light through.
//
//     mod trans id
//     0
//     0
//     7 red green blue specularity roughness transmissivity transmitted_specular
//
// transmissivity is the fraction that goes through of what is not reflected specularly, transmitted_specular
// the fraction of that which is not diffused. source: RADIANCE reference manual, "Materials"; doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_trans(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[4]};
    p.transmissivity = context.reals()[5];
    p.transmitted_specular = context.reals()[6];
    return make_ward_material(context, std::move(p), true);
}

}  // namespace infra
