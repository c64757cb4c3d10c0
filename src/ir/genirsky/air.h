// Transmittance and radiance of a path by its length, as the renderers' option -mp reads them.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/passband.h"

namespace infra::ir {

/// In one band.
struct AirValue {
    double transmittance = 1;  ///< 0..1
    double radiance = 0;       ///< W m^-2 sr^-1
};

struct AirRow {
    double distance = 0;           ///< metres
    std::vector<AirValue> values;  ///< one a band
};

/// Air of one temperature that absorbs and does not scatter.
///   temperature  kelvin        extinction  per metre, >= 0
AirRow homogeneous_air(double temperature, double extinction, double distance,
                       const std::vector<Passband>& passbands);

/// Throws Error unless distances increase from above 0 and no transmittance grows on the way.
void check_air(const std::vector<AirRow>& rows);

/// The rows, after a directive of the bands' limits. shape: bands join one another, shortest waves first; or
/// one response, whose limits no directive can say.
std::string air_text(const std::vector<AirRow>& rows, const std::vector<Passband>& passbands);

}  // namespace infra::ir
