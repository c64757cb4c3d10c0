// Spectra by wavenumber or wavelength, and what a detector sees of them.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/passband.h"
#include "ir/genirsky/spectral_axis.h"

namespace infra::ir {

/// A quantity linear between samples, along the axis that its file has.
/// shape: both vectors of one length, at least 2; places above 0, increasing.
struct SampledSpectrum {
    std::string file;           ///< where it comes from, for messages
    std::vector<double> place;  ///< cm^-1 or um
    std::vector<double> value;
    int line = 1;                                     ///< where it begins there
    SpectralAxis axis = SpectralAxis::wavenumber;     ///< of place
    SpectralAxis density = SpectralAxis::wavenumber;  ///< a radiance is in W m^-2 sr^-1/cm^-1 or /um
};

/// Planck's law by wavenumber: W m^-2 sr^-1/cm^-1 of a black surface of `temperature` kelvin.
double wavenumber_radiance(double temperature, double wavenumber);

/// Integral of a spectral radiance times the passband's weight, W m^-2 sr^-1: that of straight lines between
/// the samples.
///   throws    Error when the passband reaches beyond the spectrum
///   accuracy  of the quadrature: exact where axis and density are the same and the weight is 1, 1e-9 else
double band_integral(const SampledSpectrum& spectrum, const Passband& passband);

/// Mean of the value over the passband, every wavenumber weighted by a black body's radiance besides.
double band_mean(const SampledSpectrum& spectrum, const Passband& passband, double temperature);

}  // namespace infra::ir
