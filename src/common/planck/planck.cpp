#include "common/planck/planck.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.h"
#include "common/format.h"
#include "common/planck/planck_integral.h"
#include "common/planck/planck_inverse.h"

namespace infra {
namespace {

using constants::radiance_factor;
using constants::second_radiation_um;

PlanckIntegral band_integral(double temperature, double lo_um, double hi_um) {
    const double scale = second_radiation_um / temperature;
    const double to = lo_um > 0.0 ? scale / lo_um : std::numeric_limits<double>::infinity();
    return planck_integral(scale / hi_um, to);
}

}  // namespace

void check_temperature(double temperature) {
    if (!(temperature > 0.0) || std::isinf(temperature))
        throw Error(formatted("temperature %g K is not above absolute zero", temperature));
}

void check_band(double lo_um, double hi_um) {
    if (!(lo_um >= 0.0) || !(hi_um > lo_um))
        throw Error(formatted("band %g..%g um is empty or reversed", lo_um, hi_um),
                    "give the shorter wavelength first, in micrometres");
}

double spectral_radiance(double temperature, double wavelength_um) {
    check_temperature(temperature);
    if (!(wavelength_um > 0.0) || std::isinf(wavelength_um))
        throw Error(formatted("wavelength %g um is not above 0", wavelength_um));
    const double x = second_radiation_um / (wavelength_um * temperature);
    const double fourth_power = temperature * temperature * temperature * temperature;
    return radiance_factor * fourth_power * planck_integrand(x).energy * x / wavelength_um;  // dx = x dl/l
}

double blackbody_fraction(double wavelength_temperature) {
    constexpr double pi = std::numbers::pi;
    constexpr double whole = pi * pi * pi * pi / 15.0;
    if (wavelength_temperature <= 0.0) return 0.0;
    if (std::isinf(wavelength_temperature)) return 1.0;
    const double x = second_radiation_um / wavelength_temperature;
    return planck_integral(x, std::numeric_limits<double>::infinity()).energy / whole;
}

ThermalRadiance band_thermal_radiance(double temperature, double lo_um, double hi_um) {
    check_temperature(temperature);
    check_band(lo_um, hi_um);
    const PlanckIntegral integral = band_integral(temperature, lo_um, hi_um);
    const double scale = radiance_factor * temperature * temperature * temperature;
    return {scale * temperature * integral.energy, scale * integral.slope};
}

double band_radiance(double temperature, double lo_um, double hi_um) {
    return band_thermal_radiance(temperature, lo_um, hi_um).radiance;
}

double band_radiance_slope(double temperature, double lo_um, double hi_um) {
    return band_thermal_radiance(temperature, lo_um, hi_um).slope;
}

double band_temperature(double radiance, double lo_um, double hi_um) {
    check_band(lo_um, hi_um);
    const auto law = [lo_um, hi_um](double temperature) {
        return band_thermal_radiance(temperature, lo_um, hi_um);
    };
    return invert_radiance(law, radiance);
}

}  // namespace infra
