// Spectra run along wavelength or along wavenumber.
#pragma once

namespace infra::ir {

enum class SpectralAxis {
    wavenumber,  ///< cm^-1
    wavelength   ///< um
};

constexpr double um_cm = 1e4;       ///< wavelength in um times wavenumber in cm^-1
constexpr double nm_per_um = 1000;  ///< files and channels have wavelengths in nm

/// A place on one axis as a place on the other, or itself. place > 0
constexpr double on_axis(SpectralAxis to, SpectralAxis from, double place) {
    return to == from ? place : um_cm / place;
}

}  // namespace infra::ir
