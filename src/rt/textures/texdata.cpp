// texdata: bends the normal by a vector from data files.
//
//     mod texdata id
//     8+ xfunc yfunc zfunc xdatafile ydatafile zdatafile funcfile x0 x1 .. xn transform
//     0
//     n A1 A2 .. An
//
// x is xfunc(values of the three files at x0 .. xn), and so on. source: RADIANCE reference manual,
// "Textures".
#include "rt/compile/modifier_table.h"
#include "rt/functions/data_lookup.h"

namespace infra {
namespace {

class TexData final : public Modifier {
  public:
    explicit TexData(ModifierContext& context)
        : Modifier(context.name(), context.next), bend_(context, TripleArguments::all) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double d[3];
        if (bend_.evaluate(tracer, at, d)) at.perturbation += bend_.to_scene(tracer, at, {d[0], d[1], d[2]});
        return false;
    }

  private:
    DataTriple bend_;
};

}  // namespace

std::unique_ptr<Modifier> make_texdata(ModifierContext& context) {
    return std::make_unique<TexData>(context);
}

}  // namespace infra
