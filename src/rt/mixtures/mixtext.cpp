// mixtext: one modifier (material or pattern) on the characters of a text, another around them.
//
//     mod mixtext id
//     4 foreground background fontfile textfile, or 4+ foreground background fontfile . word...
//     0
//     9 Ox Oy Oz Rx Ry Rz Dx Dy Dz, or 10 with spacing
//
// Where the text stands: text/text_block.h. source: RADIANCE reference manual, "Mixtures".
#include "rt/compile/modifier_table.h"
#include "rt/mixtures/mixture.h"
#include "rt/text/text_block.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class MixText final : public Mixture {
  public:
    explicit MixText(ModifierContext& context) : Mixture(context), text_(context, 2, 9) {}

    bool shade(Tracer& tracer, Interaction& at) const override {
        return tracer.shade_chain(text_.covers(tracer, at) ? foreground() : background(), at);
    }

  private:
    TextBlock text_;
};

}  // namespace

std::unique_ptr<Modifier> make_mixtext(ModifierContext& context) {
    return std::make_unique<MixText>(context);
}

}  // namespace infra
