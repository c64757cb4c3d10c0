// Channel names of spectral OpenEXR pictures.
//
// source: Fichet, Pacanowski, Wilkie, "An OpenEXR Layout for Spectral Images", JCGT 10 (2021): emitted light
// without polarization is in channels S0.<wavelength>, a comma for the decimal point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/spectra/channels.h"

namespace infra {

/// "S0.8250,000nm".
std::string spectral_channel_name(double nm);

struct SpectralChannel {
    std::size_t index;  ///< among all channels of the file
    double nm;
};

/// The spectral ones among a file's channels, longest wavelength first. Wavelengths may be in nm, um, mm or
/// m.
std::vector<SpectralChannel> spectral_channels(const std::vector<std::string>& names);

/// Equal bands around the wavelengths; nothing when they are not equally far apart, to 0.1 %, or when there
/// are too few or too many.
std::optional<Channels> bands_around(const std::vector<SpectralChannel>& channels);

}  // namespace infra
