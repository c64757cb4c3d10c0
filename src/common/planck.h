// Thermal radiation of a black surface.
#pragma once

namespace infra {

/// SI 2019 exact constants and what follows from them.
namespace constants {
inline constexpr double planck = 6.62607015e-34;                                       // J s
inline constexpr double light_speed = 299792458.0;                                     // m/s
inline constexpr double boltzmann = 1.380649e-23;                                      // J/K
inline constexpr double second_radiation_um = 1e6 * planck * light_speed / boltzmann;  // c2 = hc/k in um K
}  // namespace constants

/// Fraction of a black body's radiance that lies below a wavelength.
///   wavelength_temperature   wavelength times temperature, um K, >= 0
///   returns                  0..1
///   source    Widger & Woodall, "Integration of the Planck blackbody radiation function", Bull. Amer.
///   Meteor. Soc. 57
///             (1976) 1217: sum over n of exp(-nx) (x^3/n + 3x^2/n^2 + 6x/n^3 + 6/n^4); its complement in
///             powers of x for small x.
///   accuracy  1e-12 absolute
double blackbody_fraction(double wavelength_temperature);

/// In-band radiance of a black surface.
///   temperature  kelvin, > 0         band  wavelengths in um, 0 <= lo < hi (hi may be infinite)
///   returns      W m^-2 sr^-1, integrated over the band (not per um)
///   throws       Error outside those ranges
///   accuracy     1e-9 relative where the band holds more than 1e-3 of the total, VALIDATION V1
double band_radiance(double temperature, double lo_um, double hi_um);

}  // namespace infra
