// Skies, seas and suns as RADIANCE primitives.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/dome.h"
#include "ir/genirsky/request.h"

namespace infra::ir {

/// A glow on a `source` of half the sphere, by brightfunc and elevsky.cal, hemisky.cal or hemisea.cal; of
/// several channels by specfunc and spectral.cal.
///   domes  one, or one a channel with the channels' values, longest wavelengths first; all of one size
std::string dome_text(const Request& request, const std::vector<Dome>& domes);

/// A light on a `source`, with a `spectrum` where there are channels.
///   radiances  as domes
std::string sun_text(const Request& request, const std::vector<double>& radiances);

}  // namespace infra::ir
