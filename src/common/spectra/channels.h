// What the channels of a Spectrum stand for: red, green and blue, or N equal bands of a range of wavelengths.
//
// Spectral channels run from the longest wavelength to the shortest, as RADIANCE 6 has them. A channel's
// value is N times the radiance in its band, so that the mean of the channels is the radiance in the whole
// range: a grey 1 in RGB is 1 in every channel, and spectral radiance per um is the value over the range's
// width in um.
//
// A rendering that is split into components (rt/split/split.h) has all bands once for each of them, those of
// the first component first.
#pragma once

#include <span>
#include <string>

#include "common/spectra/spectrum.h"

namespace infra {

class Channels {
  public:
    static constexpr int fewest = 3;
    static constexpr int most = 24;              ///< bands, as RADIANCE's MAXCSAMP
    static constexpr double red_limit_nm = 780;  ///< of the range when none is given
    static constexpr double blue_limit_nm = 380;
    static constexpr double red_from_nm = 588;  ///< where green ends, RADIANCE's choice
    static constexpr double green_from_nm = 480;

    /// Red, green and blue: no wavelengths but those of the visible range.
    Channels() = default;
    /// `count` bands of nm_a..nm_b, in either order.
    ///   throws  Error for fewer than 3 or more than 24, wavelengths that are equal, not above 0 or infinite
    static Channels spectral(int count, double nm_a, double nm_b);

    /// The same bands once for each of so many components.
    ///   throws  Error if that is more than a Spectrum holds
    Channels with_components(int components) const;
    /// Those of a single component.
    Channels one_component() const;

    /// Values of a spectrum: bands times components.
    int count() const { return bands_ * components_; }
    int bands() const { return bands_; }
    int components() const { return components_; }
    /// Which band channel c is, 0 .. bands() - 1.
    int band_of(int c) const { return components_ == 1 ? c : c % bands_; }
    /// RGB bands.
    bool is_rgb() const { return rgb_; }

    /// Whether the range reaches red, green and blue light.
    bool shows_colors() const;

    /// Ends of the whole range.
    double longest_nm() const { return longest_; }
    double shortest_nm() const { return shortest_; }
    /// Ends and middle of channel c, 0 .. count - 1.
    double upper_nm(int c) const { return edge_nm(band_of(c)); }
    double lower_nm(int c) const { return edge_nm(band_of(c) + 1); }
    double upper_um(int c) const { return 1e-3 * upper_nm(c); }
    double lower_um(int c) const { return 1e-3 * lower_nm(c); }
    double center_nm(int c) const { return 0.5 * (upper_nm(c) + lower_nm(c)); }

    /// Which of red (0), green (1) and blue (2) an RGB triple gives to channel c: above 588 nm, above 480 nm
    /// and below, as RADIANCE; a third of a range that does not reach all three. The channel's middle counts.
    int primary_of(int c) const;
    Spectrum from_rgb(double red, double green, double blue) const;

    /// A spectrum of the bands given to every component.
    Spectrum in_all_components(const Spectrum& bands) const;
    /// What a spectrum has in one component; 0 in the others.
    Spectrum in_component(int component, const Spectrum& all) const;

    /// In words: "RGB", "8 channels of 8000-12000 nm".
    std::string description() const;

    bool operator==(const Channels&) const = default;

  private:
    double edge_nm(int band) const { return longest_ + (shortest_ - longest_) * band / bands_; }

    int bands_ = 3;
    int components_ = 1;
    bool rgb_ = true;
    double longest_ = red_limit_nm, shortest_ = blue_limit_nm;
};

}  // namespace infra
