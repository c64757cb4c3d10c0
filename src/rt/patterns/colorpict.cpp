// colorpict: multiplies red, green and blue by the colours of a picture.
//
//     mod colorpict id
//     7+ rfunc gfunc bfunc pictfile funcfile u v transform
//     0
//     n A1 A2 .. An
//
// Red is rfunc(red, green and blue of the picture at u, v), and so on; gfunc and bfunc may take their own
// value alone. u and v run from 0 to 1 along the picture's shorter side: common/pictures/picture_table.h.
// source: RADIANCE reference manual, "Patterns".
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/functions/data_lookup.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class ColorPicture final : public Modifier {
  public:
    explicit ColorPicture(ModifierContext& context)
        : Modifier(context.name(), context.next),
          picture_(shared_picture(context, context.strings()[3])),
          functions_(context, 5, 2, 4),
          color_(context, functions_, TripleArguments::all_or_own) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        double place[2], pixel[3], rgb[3];
        FunctionCall call(functions_, tracer, at);
        call.expressions(place);
        picture_->vector(place, pixel);
        color_.apply(call, pixel, rgb);
        if (call.ok()) at.pattern *= tracer.scene().channels().from_rgb(rgb[0], rgb[1], rgb[2]);
        return false;
    }

  private:
    std::shared_ptr<const DataTable> picture_;
    FunctionSet functions_;
    TripleFunctions color_;
};

}  // namespace

std::unique_ptr<Modifier> make_colorpict(ModifierContext& context) {
    return std::make_unique<ColorPicture>(context);
}

}  // namespace infra
