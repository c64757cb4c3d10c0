// texfunc: bends the normal by a vector from a function file.
//
//     mod texfunc id
//     4+ xpert ypert zpert funcfile transform
//     0
//     n A1 A2 .. An
//
// source: RADIANCE reference manual, "Textures".
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"

namespace infra {
namespace {

class TexFunc final : public Modifier {
  public:
    explicit TexFunc(ModifierContext& context)
        : Modifier(context.name(), context.next), bend_(context, 0, 3, 3) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double d[3];
        if (bend_.evaluate(tracer, at, d)) at.perturbation += bend_.to_scene(tracer, at, {d[0], d[1], d[2]});
        return false;
    }

  private:
    FunctionSet bend_;
};

}  // namespace

std::unique_ptr<Modifier> make_texfunc(ModifierContext& context) {
    return std::make_unique<TexFunc>(context);
}

}  // namespace infra
