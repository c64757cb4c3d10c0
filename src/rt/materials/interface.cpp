// interface: the surface between two bodies of clear matter, normals towards the second.
//
//     mod interface id
//     0
//     0
//     8 red1 green1 blue1 index1 red2 green2 blue2 index2
//
// The first body lies behind the surface, the second before it; colours and indices are those of dielectric.
// source: RADIANCE reference manual, "Materials".
#include "rt/compile/modifier_table.h"
#include "rt/materials/refracting_surface.h"

namespace infra {

std::unique_ptr<Modifier> make_interface(ModifierContext& context) {
    return std::make_unique<RefractingSurface>(context, ClearBody(context, 0), ClearBody(context, 4));
}

}  // namespace infra
