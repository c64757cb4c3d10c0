// The scale between black-body temperature and radiance that a detector sees: a band or a spectral response.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <variant>

#include "common/planck/planck_response.h"

namespace infra {

class RadianceScale {
  public:
    /// Of a band with equal weights; 0.2 <= lo < hi <= 1000 um. throws Error otherwise.
    static RadianceScale of_band(double lo_um, double hi_um);
    /// Of a detector.
    static RadianceScale of_response(SpectralResponse response);
    /// Of a band written as in a picture's header: "8-12 um", "8..12 um" or "8 12".
    /// throws Error for anything else.
    static RadianceScale parse(const std::string& text);

    /// Radiance in W m^-2 sr^-1 of a black surface and its slope; temperature in kelvin, > 0.
    ThermalRadiance at(double temperature) const;
    /// The temperature in kelvin of a black surface of this radiance, as band_temperature().
    double temperature(double radiance) const;

    /// N values at once. shape: both spans of one length; they may be the same memory.
    /// throws Error as for a single value, "value 3: ...", counted from 1.
    void radiances(std::span<const double> temperatures, std::span<double> results) const;
    void slopes(std::span<const double> temperatures, std::span<double> results) const;
    void temperatures(std::span<const double> radiances, std::span<double> results) const;

    /// "8-12 um", or "response" and the name of its file.
    std::string description() const;

  private:
    using Band = std::pair<double, double>;
    explicit RadianceScale(std::variant<Band, SpectralResponse> law) : law_(std::move(law)) {}

    std::variant<Band, SpectralResponse> law_;
};

}  // namespace infra
