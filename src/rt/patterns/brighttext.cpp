// brighttext: multiplies the light that its material sends out by one number on the characters of a text,
// and by another around them.
//
//     mod brighttext id
//     2 fontfile textfile, or 2+ fontfile . word...
//     0
//     11 Ox Oy Oz Rx Ry Rz Dx Dy Dz foreground background, or 12 with spacing
//
// Where the text stands: text/text_block.h. source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/text/text_block.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class BrightText final : public Modifier {
  public:
    explicit BrightText(ModifierContext& context)
        : Modifier(context.name(), context.next),
          text_(context, 0, 11),
          foreground_(static_cast<float>(context.reals()[9])),
          background_(static_cast<float>(context.reals()[10])) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        at.pattern *= text_.covers(tracer, at) ? foreground_ : background_;
        return false;
    }

  private:
    TextBlock text_;
    float foreground_, background_;
};

}  // namespace

std::unique_ptr<Modifier> make_brighttext(ModifierContext& context) {
    return std::make_unique<BrightText>(context);
}

}  // namespace infra
