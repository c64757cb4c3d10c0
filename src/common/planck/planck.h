// Thermal radiation of a black surface: in a band of wavelengths, its slope, and the way back to temperature.
// Through a detector's response: common/planck/planck_response.h. Either by one interface:
// common/planck/planck_scale.h.
#pragma once

namespace infra {

/// SI 2019 exact constants and what follows from them.
namespace constants {
inline constexpr double planck = 6.62607015e-34;                                       // J s
inline constexpr double light_speed = 299792458.0;                                     // m/s
inline constexpr double boltzmann = 1.380649e-23;                                      // J/K
inline constexpr double second_radiation_um = 1e6 * planck * light_speed / boltzmann;  // c2 = hc/k in um K
/// Radiance is this times T^4 times the integral of x^3/(e^x - 1) over x = c2/(wavelength T): 2 k^4/(h^3
/// c^2).
inline constexpr double radiance_factor = 2.0 * (boltzmann / planck) * (boltzmann / planck) *
                                          (boltzmann / planck) * boltzmann /
                                          (light_speed * light_speed);  // W m^-2 sr^-1 K^-4
}  // namespace constants

/// Radiance and how fast it grows with temperature.
struct ThermalRadiance {
    double radiance = 0;  ///< W m^-2 sr^-1
    double slope = 0;     ///< dL/dT, W m^-2 sr^-1 K^-1
};

/// Temperatures between which radiances are turned back into temperatures, in kelvin.
inline constexpr double coldest_temperature = 1.0;
inline constexpr double hottest_temperature = 1e5;

/// Throws Error unless the temperature is above 0 K and finite.
void check_temperature(double temperature);
/// Throws Error unless 0 <= lo_um < hi_um.
void check_band(double lo_um, double hi_um);

/// Radiance of a black surface at one wavelength, Planck's law.
///   temperature  kelvin, > 0         wavelength_um  > 0
///   returns      W m^-2 sr^-1 um^-1; 0 where it is below the smallest double
///   throws       Error outside those ranges
double spectral_radiance(double temperature, double wavelength_um);

/// Fraction of a black body's radiance that lies below a wavelength.
///   wavelength_temperature   wavelength times temperature, um K, >= 0
///   returns                  0..1
///   accuracy                 1e-12 absolute
double blackbody_fraction(double wavelength_temperature);

/// In-band radiance of a black surface.
///   temperature  kelvin, > 0         band  wavelengths in um, 0 <= lo < hi (hi may be infinite)
///   returns      W m^-2 sr^-1, integrated over the band (not per um)
///   throws       Error outside those ranges
///   accuracy     1e-11 relative, however narrow the band and wherever it lies, VALIDATION V1
double band_radiance(double temperature, double lo_um, double hi_um);

/// dL/dT of band_radiance, W m^-2 sr^-1 K^-1; ranges and accuracy as there.
double band_radiance_slope(double temperature, double lo_um, double hi_um);

/// Both at little more than the cost of one.
ThermalRadiance band_thermal_radiance(double temperature, double lo_um, double hi_um);

/// The inverse of band_radiance: the temperature at which a black surface has this radiance in the band.
///   radiance     W m^-2 sr^-1, > 0
///   returns      kelvin, coldest_temperature..hottest_temperature
///   throws       Error for a radiance that is not positive or that no temperature in the range has
///   accuracy     1e-8 K up to 3000 K
double band_temperature(double radiance, double lo_um, double hi_um);

}  // namespace infra
