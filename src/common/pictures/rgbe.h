// Pixels of a mantissa a channel and a shared exponent, a byte each: the numbers of RADIANCE's pictures.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace infra {

/// Red, green, blue, exponent. An exponent of 0 is black.
using Rgbe = std::array<std::uint8_t, 4>;

/// Mantissas round down, as RADIANCE's; the reader adds one half. Negative channels become 0, the brightest
/// below 1e-32 black, and what is beyond 2^127 (infinity too) the largest number. NaN counts as 0: renderers
/// look for it before.
Rgbe to_rgbe(float red, float green, float blue);
/// The same for any number of channels.
///   pixel  one byte more than there are channels, the exponent last
void to_common_exponent(std::span<const float> channels, std::span<std::uint8_t> pixel);

/// (mantissa + 1/2) · 2^(exponent-136) a channel, 0 for black.
std::array<float, 3> from_rgbe(const Rgbe& pixel);

/// The factor 2^(exponent-136), 0 for an exponent of 0.
float rgbe_factor(std::uint8_t exponent);

}  // namespace infra
