#include "ir/genirsky/passband.h"

#include <algorithm>

namespace infra::ir {

Passband Passband::of_band(double lo_um, double hi_um) {
    RadianceScale scale = RadianceScale::of_band(lo_um, hi_um);
    return {{{lo_um, 1}, {hi_um, 1}}, std::move(scale), true};
}

Passband Passband::of_response(const SpectralResponse& response) {
    return {response.samples(), RadianceScale::of_response(response), false};
}

double Passband::weight(double wavelength_um) const {
    if (wavelength_um < shortest_um() || wavelength_um > longest_um()) return 0;
    const auto after =
        std::ranges::upper_bound(samples_, wavelength_um, {}, &SpectralResponse::Sample::wavelength_um);
    if (after == samples_.end()) return samples_.back().weight;
    const auto before = after - 1;
    const double part =
        (wavelength_um - before->wavelength_um) / (after->wavelength_um - before->wavelength_um);
    return before->weight + part * (after->weight - before->weight);
}

}  // namespace infra::ir
