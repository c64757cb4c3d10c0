// What a user should know of a table: reciprocity, energy, and how well it stands for its source.
#pragma once

#include "nrlbrdf/models.h"
#include "nrlbrdf/table.h"

namespace infra::ir {

/// Differences between two BRDFs over a set of geometries.
struct Difference {
    /// RMS of the difference over RMS of the values, both weighted by projected solid angle in both
    /// directions: what counts where there is energy.
    double rms = 0;
    /// Largest |difference| over the largest value, both where no angle is above 60 deg.
    double of_peak = 0;
    /// Largest |difference| over the mean of its two values, where that mean is above a hundredth of the RMS.
    double largest = 0;
    double theta_i = 0, phi = 0, theta_r = 0;  ///< where [rad]
};

/// f(theta_i, phi, theta_r) against f(theta_r, phi, theta_i) at the table's nodes.
Difference reciprocity_error(const BrdfTable& table);

/// The table against its source at the centres of the cells, where linear interpolation errs most. The
/// outermost cells, which end at 90 deg, are left out: there a source may have no bound.
Difference interpolation_error(const BrdfTable& table, const BrdfFunction& source);

/// The directional-hemispherical reflectance of the table less that of its source, which is its emissivity's
/// error but for the sign.
struct ReflectanceError {
    double largest = 0;   ///< |difference|, without a unit
    double relative = 0;  ///< its largest share of the reflectance
    double theta = 0;     ///< where the first is [rad]
};

/// For viewers at the nodes nearest to 0, 20 .. 80 deg and the centres of the cells after them. The source
/// must have f(phi) = f(-phi); its own reflectance is calculated to 1e-5 for lobes of an RMS half-width above
/// 1 deg.
ReflectanceError reflectance_error(const BrdfTable& table, const BrdfFunction& source);

/// f of the table [1/sr] by angles in radians.
double table_value(const BrdfTable& table, double theta_i, double phi, double theta_r);

/// Largest directional-hemispherical reflectance, for light from a node or towards a node.
double largest_reflectance(const BrdfTable& table);

}  // namespace infra::ir
