// What a detector sees of a spectrum: a band, or a spectral response.
#pragma once

#include <string>
#include <vector>

#include "common/planck/planck_scale.h"

namespace infra::ir {

class Passband {
  public:
    /// Weight 1 in 0.2 <= lo < hi <= 1000 um. throws Error otherwise.
    static Passband of_band(double lo_um, double hi_um);
    static Passband of_response(const SpectralResponse& response);

    /// By wavelength, linear between samples, 0 beyond their ends; wavelengths increase.
    const std::vector<SpectralResponse::Sample>& samples() const { return samples_; }
    double weight(double wavelength_um) const;

    double shortest_um() const { return samples_.front().wavelength_um; }
    double longest_um() const { return samples_.back().wavelength_um; }

    /// Of black bodies.
    const RadianceScale& scale() const { return scale_; }
    /// "8-12 um", or "response" and the name of its file.
    std::string description() const { return scale_.description(); }
    bool is_band() const { return is_band_; }

  private:
    Passband(std::vector<SpectralResponse::Sample> samples, RadianceScale scale, bool is_band)
        : samples_(std::move(samples)), scale_(std::move(scale)), is_band_(is_band) {}

    std::vector<SpectralResponse::Sample> samples_;
    RadianceScale scale_;
    bool is_band_;
};

}  // namespace infra::ir
