// The channels of a rendering as colours: RGB, XYZ and the responses of the eye.
#pragma once

#include <array>
#include <cstddef>

#include "common/spectra/channels.h"
#include "common/spectra/color_primaries.h"
#include "common/spectra/eye_response.h"

namespace infra {

using Color = std::array<float, 3>;

/// Response of the eye to a spectrum, 1 for an equal-energy spectrum of 1. RGB counts as three bands that
/// meet at 588 and 480 nm, but x, y and z come from RADIANCE's primaries. Built once a rendering.
class Response {
  public:
    Response(const Channels& channels, EyeResponse response);
    double operator()(const Spectrum& spectrum) const;
    double weight(std::size_t channel) const { return weights_[channel]; }

  private:
    std::array<double, Channels::most> weights_{};
};

/// A spectrum as three numbers, each a weighted sum of the channels. Built once a rendering.
class ColorConverter {
  public:
    /// CIE 1931 tristimulus values, 1 1 1 for an equal-energy spectrum of 1.
    static ColorConverter xyz(const Channels& channels);
    /// RADIANCE's RGB: of RGB channels themselves; of a range that does not reach all three primaries the
    /// means of its thirds, longest wavelengths first. A colour outside RGB's gamut is mixed with the grey
    /// of its luminance until no component is negative.
    static ColorConverter rgb(const Channels& channels);
    /// The same in other primaries, adapted to their white.
    static ColorConverter rgb(const Channels& channels, const Primaries& primaries);

    /// Any range's XYZ times a matrix, kept in the gamut.
    static ColorConverter through_xyz(const Channels& channels, const glm::dmat3& xyz_to_rgb);

    Color operator()(const Spectrum& spectrum) const;

  private:
    explicit ColorConverter(const Channels& channels) : channels_(channels.count()) {}
    /// Means of the range's thirds; a channel that reaches into two of them gives each its share.
    static ColorConverter means_of_thirds(const Channels& channels);

    using Row = std::array<float, Channels::most>;
    std::array<Row, 3> rows_{};
    Row luminance_{};
    bool keeps_gamut_ = false;
    int channels_;
};

}  // namespace infra
