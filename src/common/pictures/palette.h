// Colour scales by name.
#pragma once

#include <span>
#include <string_view>

#include "common/pictures/image8.h"

namespace infra {

/// Colours at equal steps from the low to the high end, with linear interpolation between. On all of them
/// lightness runs steadily one way, so that equal steps look equal also in grey.
struct Palette {
    std::string_view name;
    std::span<const Rgb8> samples;  ///< at least 2; lives as long as the program
};

/// All of them: inferno (the first, and the default), magma, viridis, gray, white-hot (the same), black-hot.
std::span<const Palette> palettes();

/// The palette of a name. throws Error for an unknown one, with the names there are.
const Palette& find_palette(std::string_view name);

/// Colour of a value between 0 and 1; values outside are clamped.
Rgb8 palette_color(double t, const Palette& palette = palettes().front());

}  // namespace infra
