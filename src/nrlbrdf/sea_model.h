// The sea as facets of water whose slopes are Gaussian, by Cox and Munk, without the wind's direction.
#pragma once

#include "nrlbrdf/models.h"

namespace infra {

/// Water under wind.
struct Sea {
    double wind = 5;               ///< speed 12.5 m above the surface [m/s], 0..20
    double n = 1.218, k = 0.0508;  ///< index n + ik in the band; sea water at 10 um by Hale and Querry

    /// Variance of the slope, both axes together.
    /// source: Cox and Munk, "Measurement of the Roughness of the Sea Surface from Photographs of the Sun's
    /// Glitter", J. Opt. Soc. Am. 44 (1954) 838: 0.003 + 5.12e-3 wind
    double slope_variance() const { return 0.003 + 5.12e-3 * wind; }
};

/// Reciprocal BRDF of single reflections by visible and lit facets, with Smith's masking 1/(1 + Li + Lr).
/// What a facet sends down to other facets is lost, so that 1 minus its reflectance is above
/// sea_emissivity() by that share towards grazing angles. Without bound only where both directions graze.
///   source  Cox and Munk (1954); Smith, IEEE Trans. Antennas Propag. 15 (1967) 668
BrdfFunction cox_munk(const Sea& sea);

/// Emissivity at a viewing angle: the mean of the facets' over those that the viewer sees, each weighted by
/// its projected area cos(chi)/(cos(theta) cos(beta)). Direct emission only.
///   theta     radians, 0..pi/2
///   source    Masuda, Takashima and Takayama, Remote Sens. Environ. 24 (1988) 313
///   accuracy  1e-6; VALIDATION V10
double sea_emissivity(const Sea& sea, double theta);

}  // namespace infra
