// Between spectra and colours: sampled spectra to the channels of a rendering, channels to RGB, XYZ and the
// responses of the eye.
#pragma once

#include <array>
#include <span>

#include "common/channels.h"

namespace infra {

/// Mean over each channel's band of a spectrum given as equal bands of nm_first..nm_last (values[0] lies at
/// the nm_first end), 0 outside; for RGB channels the colour of the spectrum.
Spectrum resample(const Channels& channels, std::span<const double> values, double nm_first, double nm_last);

using Color = std::array<float, 3>;

/// CIE 1931 tristimulus values, 1 1 1 for an equal-energy spectrum of 1. Of RGB: RADIANCE's primaries.
Color to_xyz(const Channels& channels, const Spectrum& spectrum);
/// RADIANCE's RGB. A range that does not reach all three primaries gives the means of its thirds, longest
/// wavelengths first.
Color to_rgb(const Channels& channels, const Spectrum& spectrum);

/// Responses of the eye, 1 for an equal-energy spectrum of 1.
double photopic(const Channels& channels, const Spectrum& spectrum);
double scotopic(const Channels& channels, const Spectrum& spectrum);
double melanopic(const Channels& channels, const Spectrum& spectrum);

}  // namespace infra
