// trans2: a thin translucent sheet that is rougher along one direction than along the other.
//
//     mod trans2 id
//     4+ ux uy uz funcfile transform
//     0
//     8 red green blue specularity urough vrough transmissivity transmitted_specular
//
// The arguments are those of plastic2 and trans. What is transmitted specularly spreads as what is reflected
// does, so that no light source shines through. source: RADIANCE reference manual, "Materials";
// doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_trans2(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[5]};
    p.transmissivity = context.reals()[6];
    p.transmitted_specular = context.reals()[7];
    return make_oriented_ward_material(context, std::move(p), true);
}

}  // namespace infra
