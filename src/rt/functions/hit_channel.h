// The variables of a function file that any hit has: Dx, Px, Nx, T and their kin.
#pragma once

#include "rt/ray.h"
#include "scene/transform.h"

namespace infra {

/// Value of channel `number` (cal/ray_library.h) at a hit.
///   to_local  from the scene's coordinates to those that the functions are written for
///   side      factor on the normal and its cosine, -1 to undo a turn to the viewer
///   throws    Error for numbers that no ray has, and those of materials and prisms alone
double hit_channel(const Interaction& at, const Transform& to_local, double side, int number);

}  // namespace infra
