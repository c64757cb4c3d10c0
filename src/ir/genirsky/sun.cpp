#include "ir/genirsky/sun.h"

#include <cmath>
#include <numbers>

namespace infra::ir {

double Sun::radiance(const Passband& passband) const {
    return transmittance * passband.scale().at(temperature).radiance;
}

double Sun::solid_angle() const {
    const double quarter = 0.5 * half_angle_deg * std::numbers::pi / 180;
    return 4 * std::numbers::pi * std::sin(quarter) *
           std::sin(quarter);  // 1 - cos without its loss of digits
}

}  // namespace infra::ir
