// mixpict: two modifiers (materials or patterns) in a proportion from a picture.
//
//     mod mixpict id
//     7+ foreground background func pictfile funcfile u v transform
//     0
//     n A1 A2 .. An
//
// The share of the foreground is func(red, green and blue of the picture at u, v), taken between 0 and 1; u
// and v as in colorpict. source: RADIANCE reference manual, "Mixtures".
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"
#include "rt/mixtures/mixture.h"

namespace infra {
namespace {

class MixPicture final : public Blend {
  public:
    explicit MixPicture(ModifierContext& context)
        : Blend(context),
          picture_(shared_picture(context, context.strings()[3])),
          functions_(context, 5, 2, 4) {
        functions_.add_function(context, 2, 3);
    }

  private:
    bool foreground_share(Tracer& tracer, const Interaction& at, double& share) const override {
        double place[2], pixel[3];
        FunctionCall call(functions_, tracer, at);
        call.expressions(place);
        picture_->vector(place, pixel);
        share = call.call(0, pixel);
        return call.ok();
    }

    std::shared_ptr<const DataTable> picture_;
    FunctionSet functions_;
};

}  // namespace

std::unique_ptr<Modifier> make_mixpict(ModifierContext& context) {
    return std::make_unique<MixPicture>(context);
}

}  // namespace infra
