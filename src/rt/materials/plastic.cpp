// plastic: a coloured diffuse base under a white reflection.
//
//     mod plastic id
//     0
//     0
//     5 red green blue specularity roughness
//
// roughness is the RMS slope of the facets, 0 for a mirror. A smooth plastic of some specularity reflects
// more towards grazing. source: RADIANCE reference manual, "Materials"; doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_plastic(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[4]};
    return make_ward_material(context, std::move(p), false);
}

}  // namespace infra
