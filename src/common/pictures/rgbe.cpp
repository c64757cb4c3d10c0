#include "common/pictures/rgbe.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace infra {
namespace {

constexpr int exponent_bias = 128;
constexpr double smallest = 1e-32;      // darker pixels are black
constexpr float largest = 0x1.fep126f;  // mantissa 255, exponent 255

std::uint8_t mantissa(double channel, double scale) {
    return channel > 0 ? static_cast<std::uint8_t>(std::min(channel, double(largest)) * scale) : 0;
}

}  // namespace

Rgbe to_rgbe(float red, float green, float blue) {
    Rgbe pixel;
    to_common_exponent(std::array{red, green, blue}, pixel);
    return pixel;
}

void to_common_exponent(std::span<const float> channels, std::span<std::uint8_t> pixel) {
    float brightest = 0;
    for (const float channel : channels) brightest = channel > brightest ? channel : brightest;
    brightest = std::min(brightest, largest);
    if (!(brightest > smallest)) {
        std::ranges::fill(pixel, std::uint8_t{0});
        return;
    }
    // Of a number that is not denormal: above `smallest`, it is 0.5..1 times two to this.
    const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(brightest) >> 23) - 126;
    const double scale = std::bit_cast<double>(std::uint64_t(1023 + 8 - exponent) << 52);
    for (std::size_t c = 0; c < channels.size(); ++c) pixel[c] = mantissa(channels[c], scale);
    pixel[channels.size()] = static_cast<std::uint8_t>(exponent + exponent_bias);
}

float rgbe_factor(std::uint8_t exponent) {
    return exponent == 0 ? 0.0f : std::ldexp(1.0f, exponent - (exponent_bias + 8));
}

std::array<float, 3> from_rgbe(const Rgbe& pixel) {
    const float factor = rgbe_factor(pixel[3]);
    return {(pixel[0] + 0.5f) * factor, (pixel[1] + 0.5f) * factor, (pixel[2] + 0.5f) * factor};
}

}  // namespace infra
