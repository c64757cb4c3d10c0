// brightdata: multiplies the light that its material sends out by a number from a data file.
//
//     mod brightdata id
//     4+ func datafile funcfile x1 x2 .. xn transform
//     0
//     n A1 A2 .. An
//
// The number is func(value of the file at x1 .. xn). On a `thermal` of 1 K a file of kelvins is a temperature
// map. File format: common/data/data_file.h. source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/functions/data_lookup.h"

namespace infra {
namespace {

class BrightData final : public Modifier {
  public:
    explicit BrightData(ModifierContext& context)
        : Modifier(context.name(), context.next), value_(context, 0) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double factor;
        if (value_.evaluate(tracer, at, factor)) at.pattern *= static_cast<float>(factor);
        return false;
    }

  private:
    DataValue value_;
};

}  // namespace

std::unique_ptr<Modifier> make_brightdata(ModifierContext& context) {
    return std::make_unique<BrightData>(context);
}

}  // namespace infra
