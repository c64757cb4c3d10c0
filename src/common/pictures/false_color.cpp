#include "common/pictures/false_color.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "common/format.h"
#include "common/pictures/bitmap_font.h"

namespace infra {
namespace {

constexpr Rgb8 ground{24, 24, 28};
constexpr Rgb8 ink{230, 230, 230};
constexpr Rgb8 not_a_number{128, 128, 128};

/// Dots of the font for a picture of that height.
int text_scale_for(int height) { return std::clamp((height + 100) / 200, 1, 6); }

double position(double value, const FalseColorScale& scale) {
    return (value - scale.low) / (scale.high - scale.low);
}

/// Tick text with as many decimals as the step between ticks needs.
std::string tick_text(double value, double step) {
    const double size = std::max(std::abs(value), step);
    if (size >= 1e6 || step < 1e-5) return formatted("%g", value);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return formatted("%.*f", decimals, value);
}

}  // namespace

Image8 false_color(std::span<const float> values, int width, int height, const FalseColorScale& scale) {
    Image8 image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = std::isfinite(values[i]) ? palette_color(position(values[i], scale), scale.palette)
                                                   : not_a_number;
    return image;
}

std::vector<double> round_ticks(double low, double high, int count) {
    if (!(high > low) || count < 1) return {};
    const double power = std::pow(10, std::floor(std::log10((high - low) / count)));
    double step = power;
    for (const double multiple : {1, 2, 5, 10, 20, 50}) {
        step = multiple * power;
        if (std::floor(high / step + 1e-9) - std::ceil(low / step - 1e-9) + 1 <= count) break;
    }
    std::vector<double> ticks;
    const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
    for (double k = first; k <= last; ++k) ticks.push_back(k * step + 0.0);
    return ticks;
}

std::string pretty_unit(const std::string& unit) {
    static constexpr std::array<const char*, 10> superscripts{"⁰", "¹", "²", "³", "⁴",
                                                              "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (unit == "degC") return "°C";
    std::string pretty;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const char c = unit[i];
        const bool after_letter = i > 0 && std::isalpha(static_cast<unsigned char>(unit[i - 1]));
        if (c == '.' && i > 0 && i + 1 < unit.size()) {
            pretty += "·";
        } else if (after_letter && (c == '-' || std::isdigit(static_cast<unsigned char>(c)))) {
            if (c == '-') pretty += "⁻";
            if (c == '-') ++i;
            while (i < unit.size() && std::isdigit(static_cast<unsigned char>(unit[i])))
                pretty += superscripts[unit[i++] - '0'];
            --i;
        } else {
            pretty += c;
        }
    }
    return pretty;
}

Image8 draw_legend(int height, const FalseColorScale& scale, int text_scale) {
    const int line = (font_height + 2) * text_scale;
    const int margin = 4 * text_scale;
    const int bar_width = 14 * text_scale;
    const int bar_top = margin + 2 * line + line / 2;
    const int bar_height = std::max(height - bar_top - margin - line / 2, 2);
    const std::string unit = pretty_unit(scale.unit);

    const int most_ticks = std::clamp(bar_height / (2 * line), 2, 11);
    const std::vector<double> ticks = round_ticks(scale.low, scale.high, most_ticks);
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : scale.high - scale.low;
    int label_width = 0;
    for (const double tick : ticks)
        label_width = std::max(label_width, text_width(tick_text(tick, step), text_scale));
    const int label_left = margin + bar_width + 5 * text_scale;
    const int width = std::max({label_left + label_width, margin + text_width(scale.quantity, text_scale),
                                margin + text_width(unit, text_scale)}) +
                      margin;

    Image8 legend(width, height, ground);
    draw_text(legend, margin, margin, scale.quantity, ink, text_scale);
    draw_text(legend, margin, margin + line, unit, ink, text_scale);
    for (int row = 0; row < bar_height; ++row) {
        const Rgb8 color = palette_color(1 - (row + 0.5) / bar_height, scale.palette);
        for (int x = 0; x < bar_width; ++x) legend.set(margin + x, bar_top + row, color);
    }
    for (const double tick : ticks) {
        const int y = bar_top + static_cast<int>((1 - position(tick, scale)) * (bar_height - 1));
        for (int x = 0; x < 3 * text_scale; ++x) legend.set(margin + bar_width + x, y, ink);
        draw_text(legend, label_left, y - 4 * text_scale, tick_text(tick, step), ink, text_scale);
    }
    return legend;
}

Image8 false_color_with_legend(std::span<const float> values, int width, int height,
                               const FalseColorScale& scale) {
    const int least_height = 140;  // room for a legend of some use
    const int total_height = std::max(height, least_height);
    const Image8 legend = draw_legend(total_height, scale, text_scale_for(total_height));
    Image8 image(width + legend.width, total_height, ground);
    paste(image, false_color(values, width, height, scale), 0, (total_height - height) / 2);
    paste(image, legend, width, 0);
    return image;
}

}  // namespace infra
