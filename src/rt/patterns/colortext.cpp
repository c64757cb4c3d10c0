// colortext: multiplies the light that its material sends out by one color on the characters of a text, and
// by another around them.
//
//     mod colortext id
//     2 fontfile textfile, or 2+ fontfile . word...
//     0
//     15 Ox Oy Oz Rx Ry Rz Dx Dy Dz rfore gfore bfore rback gback bback, or 16 with spacing
//
// Where the text stands: text/text_block.h. source: RADIANCE reference manual, "Patterns".
#include "rt/compile/modifier_table.h"
#include "rt/text/text_block.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class ColorText final : public Modifier {
  public:
    explicit ColorText(ModifierContext& context)
        : Modifier(context.name(), context.next),
          text_(context, 0, 15),
          foreground_(context.color(9)),
          background_(context.color(12)) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        at.pattern *= text_.covers(tracer, at) ? foreground_ : background_;
        return false;
    }

  private:
    TextBlock text_;
    Spectrum foreground_, background_;
};

}  // namespace

std::unique_ptr<Modifier> make_colortext(ModifierContext& context) {
    return std::make_unique<ColorText>(context);
}

}  // namespace infra
