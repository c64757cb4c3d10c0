// Depth of field: rays of a view through all points of a lens instead of its middle.
#pragma once

#include <array>

#include "common/views/view.h"

namespace infra {

/// Moves a ray of view_ray() to another point of a lens of this diameter, so that rays of one image point
/// still meet where the view is in focus, at the length of its direction. A perspective or parallel view has
/// a plane in focus and a flat lens, the others a sphere around the view point and a lens as deep as it is
/// wide.
///   chance   of the point on the lens: three numbers in [0, 1)
///   returns  false if no direction is left
/// source: RADIANCE's rpict manual page, -pd.
bool move_on_lens(const View& view, double diameter, const std::array<double, 3>& chance, Vec3& origin,
                  Vec3& direction);

}  // namespace infra
