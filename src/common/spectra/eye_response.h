// How the eye responds to a band of wavelengths: the CIE's colour-matching functions, the rods, melanopsin.
#pragma once

namespace infra {

enum class EyeResponse { x, y, z, scotopic, melanopic };

/// Share of the response to an equal-energy spectrum that comes from wavelengths below nm, 0 to 1. The
/// published curves are moved by a fraction of a band to where RADIANCE has them: 1.5 nm towards the blue for
/// x, y and z, half a nanometre towards the red for the rods, towards the blue for melanopsin. That changes
/// its colours by up to 2 %, and ours are to be the same.
///   source    eye_tables.h, linear between its values; the distances are measured on RADIANCE 6.1
///   accuracy  2e-4 of RADIANCE's shares
double response_below(EyeResponse response, double nm);

}  // namespace infra
