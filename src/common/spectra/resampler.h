// Sampled spectra to the channels of a rendering.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "common/spectra/spectral_color.h"

namespace infra {

/// Mean over each channel's band of a spectrum given as equal bands of nm_first..nm_last (values[0] lies at
/// the nm_first end), 0 outside; for RGB channels the colour of the spectrum. There three values, longest
/// wavelengths first, are taken for RGB themselves, and a spectrum of more than 24 bands, or shortest
/// wavelengths first, is first averaged over up to 24 bands of 780..380 nm: so does RADIANCE. Built once for
/// spectra that have their wavelengths in common.
class Resampler {
  public:
    ///   count              bands of the spectra
    ///   nm_first, nm_last  above 0, not equal
    Resampler(const Channels& channels, std::size_t count, double nm_first, double nm_last);

    /// shape: `count` values
    Spectrum operator()(std::span<const double> values) const;

  private:
    /// What a band of the spectrum adds to one of bands_.
    struct Share {
        std::size_t sample;
        std::size_t band;
        double weight;
    };
    void add_shares(const Channels& bands, std::size_t count, double nm_first, double nm_last);

    Channels channels_;
    std::size_t bands_;
    std::vector<Share> shares_;
    std::optional<ColorConverter> color_;  ///< of the bands, where they are not the channels
};

/// A single spectrum.
Spectrum resample(const Channels& channels, std::span<const double> values, double nm_first, double nm_last);

}  // namespace infra
