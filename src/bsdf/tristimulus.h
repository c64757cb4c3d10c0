// Colours of BSDF files: CIE XYZ, in which scattering adds up, and what they turn into.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace infra {

/// CIE 1931 tristimulus values relative to the equal-energy white: a grey f is (f, f, f).
using Xyz = glm::dvec3;

/// luminance and the CIE 1976 chromaticity u', v'.
Xyz xyz_of_yuv(double luminance, double u, double v);

/// Responses of "sharp" sensors, hardly any of which is negative for real colours. RADIANCE compares the
/// colours of a file in this space. source: Finlayson, Drew & Funt (1994)
glm::dvec3 sharp_of_xyz(const Xyz& color);
Xyz xyz_of_sharp(const glm::dvec3& sharp);

/// In RADIANCE's primaries. A colour outside their gamut is mixed with the grey of its luminance until no
/// component is negative.
std::array<double, 3> rgb_of_xyz(const Xyz& color);

}  // namespace infra
