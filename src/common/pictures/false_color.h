// False-colour pictures with a legend.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/pictures/image8.h"
#include "common/pictures/palette.h"

namespace infra {

/// What the colours stand for.
struct FalseColorScale {
    double low = 0;        ///< value at the low end of the colours
    double high = 1;       ///< value at the other end, > low
    std::string quantity;  ///< title, "radiance"
    std::string unit;      ///< "W·m⁻²·sr⁻¹"; ASCII "W.m-2.sr-1" is drawn with superscripts too
    Palette palette = palettes().front();  ///< the colours
};

/// Colours `values` (width*height, top row first). Values that are not finite become mid-grey.
Image8 false_color(std::span<const float> values, int width, int height, const FalseColorScale& scale);

/// Vertical bar with ticks at round values, title and unit.
Image8 draw_legend(int height, const FalseColorScale& scale, int text_scale = 1);

/// The false-colour picture with its legend to the right, on a dark ground.
Image8 false_color_with_legend(std::span<const float> values, int width, int height,
                               const FalseColorScale& scale);

/// Round numbers (1, 2 or 5 times a power of ten) between low and high, at most `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

/// "W.m-2.sr-1" -> "W·m⁻²·sr⁻¹", "degC" -> "°C"; texts without that form stay.
std::string pretty_unit(const std::string& unit);

}  // namespace infra
