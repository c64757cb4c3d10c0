// Red, green and blue as chromaticities, and the matrices between such a space and CIE XYZ.
#pragma once

#include <glm/mat3x3.hpp>

namespace infra {

/// CIE 1931 chromaticity coordinates.
struct Chromaticity {
    double x = 0, y = 0;
};

struct Primaries {
    Chromaticity red, green, blue, white;
};

/// RADIANCE's: nominal monitor phosphors and the equal-energy white.
constexpr Primaries radiance_primaries() {
    return {{.640, .330}, {.290, .600}, {.150, .060}, {1. / 3, 1. / 3}};
}

/// Whether the primaries span a plane of colours around a white that has luminance, within RADIANCE's limits:
/// x, y and x + y between -2 and 3, white within 0 to 1, no two of the four the same to 1e-4.
bool usable(const Primaries& primaries);

/// RGB 1 1 1 gives the white with Y = 1. The inverse below, and the space of another white first adapted
/// from the equal-energy white (von Kries, in the cone space of "sharp" sensors, as RADIANCE).
///   primaries  usable
glm::dmat3 rgb_to_xyz(const Primaries& primaries);
glm::dmat3 xyz_to_rgb(const Primaries& primaries);
glm::dmat3 adapted_xyz_to_rgb(const Primaries& primaries);

}  // namespace infra
