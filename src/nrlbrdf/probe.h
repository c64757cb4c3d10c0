// The Gaussian probe: directions around the mirror direction, from half vectors whose slopes are Gaussian
// (Ward's and Beckmann's distribution) of RMS slope alpha. What falls below the surface is lost: its density
// counts as missing. source: Ward, "Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992, eq. 6
// and 7.
#pragma once

#include "common/vec.h"

namespace infra {

/// A unit direction, perhaps below the surface; u in [0,1).
Vec3 sample_probe(const Vec3& wo, double alpha, double u1, double u2);

/// Its density [1/sr] for wi above the surface, wo above too; 0 below.
double probe_pdf(const Vec3& wo, const Vec3& wi, double alpha);

}  // namespace infra
