#include "ir/region_marks.h"

#include <algorithm>

#include "common/format.h"
#include "common/pictures/bitmap_font.h"

namespace infra::ir {
namespace {

constexpr Rgb8 black{0, 0, 0};
constexpr Rgb8 white{255, 255, 255};

/// Mean lightness of the region's pixels, 0..255, with the Rec. 709 weights.
double lightness(const Image8& image, const Region& region, int offset) {
    double sum = 0;
    long count = 0;
    for (int y = region.y0 + offset; y < region.y1 + offset; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const Rgb8& pixel = image.at(x, y);
            sum += 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
            ++count;
        }
    }
    return sum / double(count);
}

}  // namespace

void mark_region(Image8& image, const Region& region, double mean, int offset) {
    const Rgb8 ink = lightness(image, region, offset) > 110 ? black : white;
    const int top = region.y0 + offset, bottom = region.y1 - 1 + offset;
    for (int x = region.x0; x < region.x1; ++x) {
        image.set(x, top, ink);
        image.set(x, bottom, ink);
    }
    for (int y = top; y <= bottom; ++y) {
        image.set(region.x0, y, ink);
        image.set(region.x1 - 1, y, ink);
    }
    const std::string figure = formatted("%#.5g", mean);
    const int wanted = std::max(text_width(region.label), text_width(figure)) + 6;
    const int text_scale = std::clamp((region.x1 - region.x0) / wanted, 1, 3);
    const int margin = 3 * text_scale;
    int y = top + margin;
    if (!region.label.empty()) {
        draw_text(image, region.x0 + margin, y, region.label, ink, text_scale);
        y += (font_height + 1) * text_scale;
    }
    draw_text(image, region.x0 + margin, y, figure, ink, text_scale);
}

}  // namespace infra::ir
