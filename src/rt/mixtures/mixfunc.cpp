// mixfunc: two modifiers (materials or patterns) in a proportion from a function file.
//
//     mod mixfunc id
//     4+ foreground background vname funcfile transform
//     0
//     n A1 A2 .. An
//
// vname is the share of the foreground, taken between 0 and 1. source: RADIANCE reference manual, "Mixtures".
#include <algorithm>

#include "rt/functions.h"
#include "rt/mixtures/mixture.h"
#include "rt/modifier_table.h"

namespace infra {
namespace {

class MixFunc final : public Modifier {
  public:
    explicit MixFunc(ModifierContext& context)
        : Modifier(context.name(), context.next),
          traits_{.name = context.name(), .is_mixture = true},
          foreground_(context.modifier_named(context.strings()[0])),
          background_(context.modifier_named(context.strings()[1])),
          share_(context, 2, 1, 3),
          mixes_materials_(material_of(foreground_) || material_of(background_)) {
        if (context.next && mixes_materials_)
            throw context.error("inappropriate modifier on a mixture of materials",
                                "modify the materials instead");
    }

    bool shade(Tracer& tracer, Interaction& at) const override {
        double share;
        if (!share_.evaluate(tracer, at, &share)) return false;
        return shade_mixture(tracer, at, foreground_, background_, std::clamp(share, 0.0, 1.0));
    }

    const MaterialTraits* traits() const override { return mixes_materials_ ? &traits_ : nullptr; }

  private:
    MaterialTraits traits_;
    const Modifier* foreground_;
    const Modifier* background_;
    FunctionSet share_;
    bool mixes_materials_;
};

}  // namespace

std::unique_ptr<Modifier> make_mixfunc(ModifierContext& context) {
    return std::make_unique<MixFunc>(context);
}

}  // namespace infra
