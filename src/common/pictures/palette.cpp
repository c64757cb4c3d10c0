#include "common/pictures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/error.h"

namespace infra {
namespace {

constexpr Rgb8 rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8 & 255),
            static_cast<std::uint8_t>(hex & 255)};
}

// Samples at 0, 0.1, ... 1 of matplotlib's scales (S. van der Walt, N. Smith, E. Firing; CC0).
constexpr std::array inferno = {rgb(0x000004), rgb(0x160b39), rgb(0x420a68), rgb(0x6a176e),
                                rgb(0x932667), rgb(0xbc3754), rgb(0xdd513a), rgb(0xf37819),
                                rgb(0xfca50a), rgb(0xf6d746), rgb(0xfcffa4)};
constexpr std::array magma = {rgb(0x000004), rgb(0x150e37), rgb(0x3b0f70), rgb(0x641a80),
                              rgb(0x8c2981), rgb(0xb63679), rgb(0xde4968), rgb(0xf66f5c),
                              rgb(0xfe9f6d), rgb(0xfece91), rgb(0xfcfdbf)};
constexpr std::array viridis = {rgb(0x440154), rgb(0x482576), rgb(0x414487), rgb(0x35608d),
                                rgb(0x2a788e), rgb(0x21908c), rgb(0x22a884), rgb(0x43bf71),
                                rgb(0x7ad151), rgb(0xbbdf27), rgb(0xfde725)};
// sRGB's own curve makes equal steps of grey look about equal.
constexpr std::array white_hot = {rgb(0x000000), rgb(0xffffff)};
constexpr std::array black_hot = {rgb(0xffffff), rgb(0x000000)};

constexpr std::array<Palette, 6> all = {{{"inferno", inferno},
                                         {"magma", magma},
                                         {"viridis", viridis},
                                         {"gray", white_hot},
                                         {"white-hot", white_hot},
                                         {"black-hot", black_hot}}};

}  // namespace

std::span<const Palette> palettes() { return all; }

const Palette& find_palette(std::string_view name) {
    const auto found = std::ranges::find(all, name, &Palette::name);
    if (found != all.end()) return *found;
    std::string names;
    for (const Palette& palette : all) names.append(names.empty() ? "" : ", ").append(palette.name);
    throw Error("there is no palette \"" + std::string(name) + "\"", "there are " + names);
}

Rgb8 palette_color(double t, const Palette& palette) {
    const std::span<const Rgb8> samples = palette.samples;
    const double place = std::clamp(t, 0.0, 1.0) * double(samples.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), samples.size() - 2);
    const double weight = place - double(below);
    Rgb8 color{};
    for (int c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(
            std::lround((1 - weight) * samples[below][c] + weight * samples[below + 1][c]));
    return color;
}

}  // namespace infra
