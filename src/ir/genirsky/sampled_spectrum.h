// Spectra by wavenumber, and what a detector sees of them.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/passband.h"

namespace infra::ir {

/// A quantity by wavenumber, linear between samples. A spectral radiance is in W m^-2 sr^-1/cm^-1.
/// shape: both vectors of one length, at least 2; wavenumbers in cm^-1, above 0, increasing.
struct SampledSpectrum {
    std::string file;  ///< where it comes from, for messages
    std::vector<double> wavenumber;
    std::vector<double> value;
};

/// Planck's law by wavenumber: W m^-2 sr^-1/cm^-1 of a black surface of `temperature` kelvin.
double wavenumber_radiance(double temperature, double wavenumber);

/// Integral over wavenumber of value times the passband's weight: for a spectral radiance W m^-2 sr^-1.
///   throws    Error when the passband reaches beyond the spectrum
///   accuracy  that of the spectrum's linear interpolation; the quadrature adds 1e-9
double band_integral(const SampledSpectrum& spectrum, const Passband& passband);

/// Mean of the value over the passband, every wavenumber weighted by a black body's radiance besides.
double band_mean(const SampledSpectrum& spectrum, const Passband& passband, double temperature);

}  // namespace infra::ir
