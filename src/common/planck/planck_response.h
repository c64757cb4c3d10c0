// A detector's spectral response, and black bodies seen through it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/planck/planck.h"

namespace infra {

/// Wavelengths that bands and responses may have, in um. What lies outside is nearly always a slip of unit.
inline constexpr double shortest_wavelength_um = 0.2;
inline constexpr double longest_wavelength_um = 1000.0;

/// Weight by wavelength, linear between samples and zero beyond the first and the last. The weighted radiance
/// is the integral of weight times spectral radiance: in-band radiance where the weights are 1.
class SpectralResponse {
  public:
    struct Sample {
        double wavelength_um = 0;
        double weight = 0;
    };

    /// Reads a text file, "-" being the standard input.
    /// throws Error when it cannot be read, and as parse().
    static SpectralResponse read(const std::string& path);

    /// Reads lines of a wavelength in um and a weight; '#' starts a comment.
    ///   name    for messages
    ///   throws  Error with file and line for anything but two numbers, wavelengths that do not increase or
    ///           lie outside 0.2..1000 um, weights below 0, fewer than two samples, and weights that are all
    ///           0
    static SpectralResponse parse(std::string_view text, const std::string& name);

    const std::vector<Sample>& samples() const { return samples_; }
    const std::string& name() const { return name_; }

    /// Weighted radiance of a black surface and its slope.
    ///   temperature  kelvin, > 0
    ///   throws       Error outside that range
    ///   accuracy     1e-10 relative for the piecewise linear weights (Gauss-Legendre on every segment)
    ThermalRadiance thermal_radiance(double temperature) const;

    /// The temperature of a black surface with this weighted radiance, as band_temperature().
    double temperature(double radiance) const;

  private:
    SpectralResponse(std::vector<Sample> samples, std::string name);

    std::vector<Sample> samples_;
    std::string name_;
};

}  // namespace infra
