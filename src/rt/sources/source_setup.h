// From a surface whose material gives light to the light source that is sampled.
#pragma once

#include "rt/materials/light_material.h"
#include "rt/sources/light_source.h"
#include "scene/scene.h"

namespace infra {

/// Geometry and emission of a source.
///   throws  Error for a surface that cannot be one: a cone, a ring with a hole, no area, a polygon around
///   its centre
LightSource make_light_source(const Scene& scene, PrimitiveId surface, const Emitter& emitter,
                              std::vector<std::string>& warnings);

}  // namespace infra
