// What makes a BRDF fit to render with, when asked for.
#pragma once

#include "nrlbrdf/models.h"

namespace infra::ir {

/// The mean of f and f with exchanged directions: reciprocal.
BrdfFunction symmetrized(BrdfFunction f);

/// f with polar angles beyond `limit` [rad] taken for `limit`: finite at 90 deg.
BrdfFunction limited(BrdfFunction f, double limit);

/// What clamp_energy did.
struct EnergyRepair {
    double largest_before = 0;  ///< largest directional-hemispherical reflectance, either way
    double largest_after = 0;
    double least_factor = 1;  ///< smallest that a value was multiplied by
    int passes = 0;
};

/// Scales the table down where it reflects more than it receives, for light from an angle theta_i or towards
/// an angle theta_r: f(theta_i, phi, theta_r) times a(theta_i) b(theta_r), with factors of 1 where nothing is
/// wrong. a = b on a reciprocal table with equal counts, which stays reciprocal.
EnergyRepair clamp_energy(BrdfGrid& grid);

}  // namespace infra::ir
