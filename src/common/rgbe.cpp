#include "common/rgbe.h"

#include <algorithm>
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
    const float brightest = std::min(std::fmax(std::fmax(red, green), blue), largest);
    if (!(brightest > smallest)) return {0, 0, 0, 0};
    int exponent = 0;
    const double scale = std::frexp(double(brightest), &exponent) * 256.0 / brightest;
    return {mantissa(red, scale), mantissa(green, scale), mantissa(blue, scale),
            static_cast<std::uint8_t>(exponent + exponent_bias)};
}

float rgbe_factor(std::uint8_t exponent) {
    return exponent == 0 ? 0.0f : std::ldexp(1.0f, exponent - (exponent_bias + 8));
}

std::array<float, 3> from_rgbe(const Rgbe& pixel) {
    const float factor = rgbe_factor(pixel[3]);
    return {(pixel[0] + 0.5f) * factor, (pixel[1] + 0.5f) * factor, (pixel[2] + 0.5f) * factor};
}

}  // namespace infra
