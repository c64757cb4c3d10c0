// What a surface full of holes lets straight through: the peak of its transmission that looks at the viewer's
// own direction, found in the table, whose patches are wider than the holes' image.
#pragma once

#include "rt/materials/bsdf_hit.h"

namespace infra {

/// The peak around the direction straight on, without the Lambertian part, times the patterns; nothing where
/// there is no such peak. source: measured from RADIANCE 6.1.
Aperture find_aperture(const BsdfHit& hit);

}  // namespace infra
