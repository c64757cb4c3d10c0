#include "nrlbrdf/fresnel.h"

#include <complex>

namespace infra {

double fresnel_reflectance(double cos_theta, double n, double k) {
    const std::complex<double> permittivity = std::complex<double>(n, k) * std::complex<double>(n, k);
    // Normal component of the wave vector inside, in units of that in vacuum.
    const std::complex<double> inside = std::sqrt(permittivity - (1 - cos_theta * cos_theta));
    const double across = std::norm((cos_theta - inside) / (cos_theta + inside));
    const double along = std::norm((permittivity * cos_theta - inside) / (permittivity * cos_theta + inside));
    return (across + along) / 2;
}

}  // namespace infra
