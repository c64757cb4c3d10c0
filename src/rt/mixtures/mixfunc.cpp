// mixfunc: two modifiers (materials or patterns) in a proportion from a function file.
//
//     mod mixfunc id
//     4+ foreground background vname funcfile transform
//     0
//     n A1 A2 .. An
//
// vname is the share of the foreground, taken between 0 and 1. source: RADIANCE reference manual, "Mixtures".
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"
#include "rt/mixtures/mixture.h"

namespace infra {
namespace {

class MixFunc final : public Blend {
  public:
    explicit MixFunc(ModifierContext& context) : Blend(context), share_(context, 2, 1, 3) {}

  private:
    bool foreground_share(Tracer& tracer, const Interaction& at, double& share) const override {
        return share_.evaluate(tracer, at, &share);
    }

    FunctionSet share_;
};

}  // namespace

std::unique_ptr<Modifier> make_mixfunc(ModifierContext& context) {
    return std::make_unique<MixFunc>(context);
}

}  // namespace infra
