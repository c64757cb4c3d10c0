// mixdata: two modifiers (materials or patterns) in a proportion from a data file.
//
//     mod mixdata id
//     6+ foreground background func datafile funcfile x1 x2 .. xn transform
//     0
//     n A1 A2 .. An
//
// The share of the foreground is func(value of the file at x1 .. xn), taken between 0 and 1. source: RADIANCE
// reference manual, "Mixtures".
#include "rt/compile/modifier_table.h"
#include "rt/functions/data_lookup.h"
#include "rt/mixtures/mixture.h"

namespace infra {
namespace {

class MixData final : public Blend {
  public:
    explicit MixData(ModifierContext& context) : Blend(context), share_(context, 2) {}

  private:
    bool foreground_share(Tracer& tracer, const Interaction& at, double& share) const override {
        return share_.evaluate(tracer, at, share);
    }

    DataValue share_;
};

}  // namespace

std::unique_ptr<Modifier> make_mixdata(ModifierContext& context) {
    return std::make_unique<MixData>(context);
}

}  // namespace infra
