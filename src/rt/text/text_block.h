// Lines of text in a plane of the scene: what brighttext, colortext and mixtext have in common.
//
//     .. fontfile textfile        the lines of a file
//     .. fontfile . word...       a line of words, with a blank between any two
//
//     Ox Oy Oz Rx Ry Rz Dx Dy Dz .. [spacing]
//
// O is the upper left corner, R the step from one character to the next, D that from one line to the next.
// spacing, in widths of a character's square: see TextLine. The text is the same at all depths behind the
// plane. Files are found through RAYPATH. source: RADIANCE reference manual, "Patterns".
#pragma once

#include <memory>
#include <vector>

#include "common/vec.h"
#include "rt/text/text_line.h"

namespace infra {

class ModifierContext;
struct Interaction;
class Tracer;

class TextBlock {
  public:
    /// font: of the string argument that names the font; spacing: of the real argument, which may be missing.
    ///   throws  Error for missing files, what is wrong with the font, and R and D that are 0 or parallel
    TextBlock(ModifierContext& context, std::size_t font, std::size_t spacing);

    /// Whether a hit is on a character.
    bool covers(const Tracer& tracer, const Interaction& at) const;

  private:
    std::shared_ptr<const Font> font_;
    std::vector<TextLine> lines_;
    Vec3 origin_;
    Vec3 across_, down_;  ///< a place's offset times these is its column, in units of a line, and its row
};

}  // namespace infra
