// colordata: multiplies red, green and blue by numbers from data files.
//
//     mod colordata id
//     8+ rfunc gfunc bfunc rdatafile gdatafile bdatafile funcfile x1 x2 .. xn transform
//     0
//     n A1 A2 .. An
//
// Red is rfunc(values of the three files at x1 .. xn), and so on; gfunc and bfunc may take their own value
// alone. source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/functions/data_lookup.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class ColorData final : public Modifier {
  public:
    explicit ColorData(ModifierContext& context)
        : Modifier(context.name(), context.next), color_(context, TripleArguments::all_or_own) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double rgb[3];
        if (color_.evaluate(tracer, at, rgb))
            at.pattern *= tracer.scene().channels().from_rgb(rgb[0], rgb[1], rgb[2]);
        return false;
    }

  private:
    DataTriple color_;
};

}  // namespace

std::unique_ptr<Modifier> make_colordata(ModifierContext& context) {
    return std::make_unique<ColorData>(context);
}

}  // namespace infra
