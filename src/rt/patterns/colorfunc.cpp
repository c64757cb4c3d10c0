// colorfunc: multiplies red, green and blue by three numbers from a function file.
//
//     mod colorfunc id
//     4+ rrefl grefl brefl funcfile transform
//     0
//     n A1 A2 .. An
//
// source: RADIANCE reference manual, "Patterns".
#include "rt/functions.h"
#include "rt/modifier_table.h"

namespace infra {
namespace {

class ColorFunc final : public Modifier {
  public:
    explicit ColorFunc(ModifierContext& context)
        : Modifier(context.name(), context.next), color_(context, 0, 3, 3) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double rgb[3];
        if (!color_.evaluate(tracer, at, rgb)) return false;
        Spectrum factor(at.channels());
        for (int c = 0; c < 3; ++c) factor.set(c, static_cast<float>(rgb[c]));
        at.pattern *= factor;
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
