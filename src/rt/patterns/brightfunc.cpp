// brightfunc: multiplies the light that its material sends out by a number from a function file.
//
//     mod brightfunc id
//     2+ refl funcfile transform
//     0
//     n A1 A2 .. An
//
// source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"

namespace infra {
namespace {

class BrightFunc final : public Modifier {
  public:
    explicit BrightFunc(ModifierContext& context)
        : Modifier(context.name(), context.next), value_(context, 0, 1, 1) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double factor;
        if (value_.evaluate(tracer, at, &factor)) at.pattern *= static_cast<float>(factor);
        return false;
    }

  private:
    FunctionSet value_;
};

}  // namespace

std::unique_ptr<Modifier> make_brightfunc(ModifierContext& context) {
    return std::make_unique<BrightFunc>(context);
}

}  // namespace infra
