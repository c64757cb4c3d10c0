// The strata of a hemisphere of rays, n x n cells of the unit square, and where more rays are worth their
// time.
#pragma once

#include <vector>

#include "common/spectra/spectrum.h"

namespace infra {

struct HemisphereCell {
    Spectrum mean;         ///< of radiance times weight
    float weight = 0;      ///< mean of its rays'
    float brightness = 0;  ///< of its first ray, not weighted
    float variance = 0;
    int neighbours = 0;
};

/// Where a cell's neighbours differ from it its value is uncertain: adds squared differences, relative to
/// brightness, to `variance`.
///   cells  n x n, their variances 0
///   norm   1 over the brightness that the differences are measured by
void estimate_variances(std::vector<HemisphereCell>& cells, int n, double norm);

}  // namespace infra
