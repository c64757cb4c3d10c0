// Henyey and Greenstein's phase function.
#pragma once

#include <cmath>
#include <numbers>

namespace infra {

/// Density [1/sr] of directions after scattering.
///   eccentricity  mean cosine of the angle by which light is turned, below 1; RADIANCE scatters evenly below
///   0 cosine        of that angle source        Henyey & Greenstein, "Diffuse Radiation in the Galaxy",
///   Astrophysical Journal 93 (1941)
inline double henyey_greenstein(double eccentricity, double cosine) {
    constexpr double isotropic = 0.25 * std::numbers::inv_pi;
    const double g = eccentricity;
    if (g <= 1e-6) return isotropic;
    const double d = 1.0 + g * g - 2.0 * g * cosine;
    return isotropic * (1.0 - g * g) / (d * std::sqrt(d));
}

}  // namespace infra
