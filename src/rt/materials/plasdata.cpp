// plasdata, metdata: plastic and metal whose highlights stand in a data file.
//
//     mod plasdata id
//     4+ func datafile funcfile x1 x2 .. xn transform
//     0
//     4+ red green blue specularity A5 ..
//
// x1(x,y,z,omega) .. xn are functions that give the coordinates in the file of a light source in the
// direction x y z; func(value,x,y,z,omega) turns the file's value into the BRDF. All else is as in plasfunc
// and metfunc. source: RADIANCE reference manual, "Materials".
#include "rt/compile/modifier_table.h"
#include "rt/materials/programmed_material.h"

namespace infra {
namespace {

std::unique_ptr<Modifier> make(ModifierContext& context, bool metallic) {
    return std::make_unique<ProgrammedMaterial>(context, reflecting_shares(context, metallic),
                                                ProgrammedValue::Kind::data);
}

}  // namespace

std::unique_ptr<Modifier> make_plasdata(ModifierContext& context) { return make(context, false); }
std::unique_ptr<Modifier> make_metdata(ModifierContext& context) { return make(context, true); }

}  // namespace infra
