// A built-in 5x7 font for legends, so that a picture's labels need no font of the machine.
#pragma once

#include <string_view>

#include "common/pictures/image8.h"

namespace infra {

/// Size of the cell of one character at scale 1, with the gap to the next one.
inline constexpr int font_advance = 6;
inline constexpr int font_height = 9;

/// Width in pixels of a text drawn at `scale`.
int text_width(std::string_view utf8, int scale = 1);

/// Draws a text with its upper left corner at (x, y), `scale` pixels a dot. Knows printable ASCII, the
/// superscripts ⁰ ¹ ² ³ ⁴ ⁵ ⁶ ⁷ ⁸ ⁹ ⁻, and · ° µ μ λ ε – ×; anything else is drawn as a box.
void draw_text(Image8& image, int x, int y, std::string_view utf8, Rgb8 color, int scale = 1);

}  // namespace infra
