// metal: as plastic, but the reflection takes the colour of the metal.
//
//     mod metal id
//     0
//     0
//     5 red green blue specularity roughness
//
// source: RADIANCE reference manual, "Materials"; doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_metal(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[4]};
    p.metallic = true;
    return make_ward_material(context, std::move(p), false);
}

}  // namespace infra
