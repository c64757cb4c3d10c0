#include "common/planck.h"

#include <cmath>
#include <numbers>

#include "common/error.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

// Integral of x^3/(e^x - 1) from x to infinity, x > 0.
double tail_integral(double x) {
    double sum = 0.0;
    for (int n = 1; n < 400; ++n) {
        const double term =
            std::exp(-n * x) * (((x / n + 3.0 / (double(n) * n)) * x + 6.0 / (double(n) * n * n)) * x +
                                6.0 / (double(n) * n * n * n));
        sum += term;
        if (term < 1e-17 * sum) break;
    }
    return sum;
}

// Integral of x^3/(e^x - 1) from 0 to x by the Bernoulli series, for x well below 2 pi.
double head_integral(double x) {
    constexpr double coefficients[] = {1.0 / 12,          -1.0 / 720,
                                       1.0 / 30240,       -1.0 / 1209600,
                                       1.0 / 47900160,    -691.0 / 1307674368000,
                                       1.0 / 74724249600, -3617.0 / 10670622842880000};
    // x/(e^x-1) = 1 - x/2 + sum B_2k x^2k / (2k)!, and the integrand is x^2 times that.
    double sum = 1.0 / 3.0 - x / 8.0;
    double power = x * x;
    for (int k = 0; k < 8; ++k) {
        sum += coefficients[k] * power / (2 * k + 5);
        power *= x * x;
    }
    return x * x * x * sum;
}

}  // namespace

double blackbody_fraction(double wavelength_temperature) {
    if (wavelength_temperature <= 0.0) return 0.0;
    if (std::isinf(wavelength_temperature)) return 1.0;
    constexpr double whole = pi * pi * pi * pi / 15.0;
    const double x = constants::second_radiation_um / wavelength_temperature;
    return x < 1.0 ? 1.0 - head_integral(x) / whole : tail_integral(x) / whole;
}

double band_radiance(double temperature, double lo_um, double hi_um) {
    if (!(temperature > 0.0) || std::isinf(temperature))
        throw Error("temperature " + std::to_string(temperature) + " K is not above absolute zero");
    if (!(lo_um >= 0.0) || !(hi_um > lo_um))
        throw Error("band " + std::to_string(lo_um) + ".." + std::to_string(hi_um) +
                    " um is empty or reversed");
    using namespace constants;
    constexpr double sigma = 2.0 * pi * pi * pi * pi * pi * boltzmann * boltzmann * boltzmann * boltzmann /
                             (15.0 * planck * planck * planck * light_speed * light_speed);
    const double total = sigma * temperature * temperature * temperature * temperature / pi;
    return total * (blackbody_fraction(hi_um * temperature) - blackbody_fraction(lo_um * temperature));
}

}  // namespace infra
