// metal2: metal that is rougher along one direction than along the other.
//
//     mod metal2 id
//     4+ ux uy uz funcfile transform
//     0
//     6 red green blue specularity urough vrough
//
// The arguments are those of plastic2. source: RADIANCE reference manual, "Materials"; doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_metal2(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[5]};
    p.metallic = true;
    return make_oriented_ward_material(context, std::move(p), false);
}

}  // namespace infra
