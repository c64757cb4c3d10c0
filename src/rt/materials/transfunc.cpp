// transfunc, transdata: a translucent sheet whose reflection and transmission a function gives.
//
//     mod transfunc id                          mod transdata id
//     2+ brtd funcfile transform                4+ func datafile funcfile x1 x2 .. xn transform
//     0                                         0
//     6+ red green blue rspec trans tspec A7 .. 6+ red green blue rspec trans tspec A7 ..
//
// The function is that of plasfunc, the file and its functions those of plasdata, for light from both sides:
// times rspec on the viewer's side, without colour, times trans (1 - rspec) tspec on the other, coloured. The
// rest is diffuse. Direct light does not go straight through: the sheet casts a full shadow, as in RADIANCE.
// source: RADIANCE reference manual, "Materials".
#include "rt/compile/modifier_table.h"
#include "rt/materials/programmed_material.h"

namespace infra {

std::unique_ptr<Modifier> make_transfunc(ModifierContext& context) {
    return std::make_unique<ProgrammedMaterial>(context, transmitting_shares(context),
                                                ProgrammedValue::Kind::function);
}

std::unique_ptr<Modifier> make_transdata(ModifierContext& context) {
    return std::make_unique<ProgrammedMaterial>(context, transmitting_shares(context),
                                                ProgrammedValue::Kind::data);
}

}  // namespace infra
