#include "ir/genirsky/air.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {
namespace {

/// Readers take logarithms: opaque air lets this little through.
constexpr double least_transmittance = 1e-30;

}  // namespace

AirRow homogeneous_air(double temperature, double extinction, double distance,
                       const std::vector<Passband>& passbands) {
    AirRow row{distance, {}};
    for (const Passband& passband : passbands) {
        const double depth = extinction * distance;
        row.values.push_back(
            {std::exp(-depth), -std::expm1(-depth) * passband.scale().at(temperature).radiance});
    }
    return row;
}

void check_air(const std::vector<AirRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double before = i == 0 ? 0 : rows[i - 1].distance;
        if (!(rows[i].distance > before))
            throw Error(formatted("range %g m does not come after %g m", rows[i].distance, before));
        for (std::size_t band = 0; i > 0 && band < rows[i].values.size(); ++band)
            if (rows[i].values[band].transmittance > rows[i - 1].values[band].transmittance)
                throw Error(formatted("transmittance grows from %.6g at %g m to %.6g at %g m",
                                      rows[i - 1].values[band].transmittance, before,
                                      rows[i].values[band].transmittance, rows[i].distance),
                            "are the ranges in the order of the runs?");
    }
}

std::string air_text(const std::vector<AirRow>& rows, const std::vector<Passband>& passbands) {
    std::string text;
    if (passbands.front().is_band()) {
        text = "#% bands " + formatted("%.9g", passbands.front().shortest_um());
        for (const Passband& passband : passbands) text += formatted(" %.9g", passband.longest_um());
        text += "\n";
    }
    for (const AirRow& row : rows) {
        text += formatted("%.9g", row.distance);
        for (const AirValue& value : row.values)
            text +=
                formatted("  %.9g %.9g", std::max(value.transmittance, least_transmittance), value.radiance);
        text += "\n";
    }
    return text;
}

}  // namespace infra::ir
