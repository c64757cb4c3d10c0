// colorfunc: multiplies red, green and blue by three numbers from a function file.
//
//     mod colorfunc id
//     4+ rrefl grefl brefl funcfile transform
//     0
//     n A1 A2 .. An
//
// source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class ColorFunc final : public Modifier {
  public:
    explicit ColorFunc(ModifierContext& context)
        : Modifier(context.name(), context.next), color_(context, 0, 3, 3) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double rgb[3];
        if (!color_.evaluate(tracer, at, rgb)) return false;
        at.pattern *= tracer.scene().channels().from_rgb(rgb[0], rgb[1], rgb[2]);
        return false;
    }

  private:
    FunctionSet color_;
};

}  // namespace

std::unique_ptr<Modifier> make_colorfunc(ModifierContext& context) {
    return std::make_unique<ColorFunc>(context);
}

}  // namespace infra
