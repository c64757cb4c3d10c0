// What the radiance at the end of a ray counts for at the eye.
#pragma once

#include "rt/ray.h"

namespace infra {

class AirPath;

/// Product of all coefficients, weights and transmittances from where the ray ends to where the primary ray
/// began: of the radiance there, a factor a channel. What a sum is multiplied with in the end
/// (RayObserver::end_sum) is not in it.
///   air  that takes its share along camera rays, nullptr: none
Spectrum path_coefficient(const Interaction& at, const AirPath* air = nullptr);

}  // namespace infra
