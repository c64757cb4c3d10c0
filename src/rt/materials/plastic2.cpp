// plastic2: plastic that is rougher along one direction than along the other.
//
//     mod plastic2 id
//     4+ ux uy uz funcfile transform
//     0
//     6 red green blue specularity urough vrough
//
// ux uy uz is a vector: urough is the RMS slope of the facets along it, laid along the surface, vrough that
// across; both above 0. source: RADIANCE reference manual, "Materials"; doc/materials.
#include "rt/compile/modifier_table.h"
#include "rt/materials/ward_material.h"

namespace infra {

std::unique_ptr<Modifier> make_plastic2(ModifierContext& context) {
    WardParameters p{context.color(0)};
    p.specularity = context.reals()[3];
    p.facets.roughness = {context.reals()[4], context.reals()[5]};
    return make_oriented_ward_material(context, std::move(p), false);
}

}  // namespace infra
