// Pieces of scene text that several tests use.
#pragma once

#include <numbers>

#include "traced_scene.h"

namespace infra::test {

inline constexpr double degree = std::numbers::pi / 180;

/// A horizontal ring of radius 1 at the origin, of the modifier "m".
inline const std::string plate = "\nm ring plate 0 0 8 0 0 0 0 0 1 0 1\n";

/// The ray by which a viewer at these angles (radians) sees the middle of the plate.
inline RaySpec view_of_plate(double theta, double azimuth) {
    const Vec3 to_viewer = direction(theta, azimuth);
    return {to_viewer * 3.0, -to_viewer};
}

inline Estimate seen(TracedScene& scene, const RaySpec& ray, int rays) {
    return scene.mean_radiance(rays, ray.origin, ray.direction);
}

}  // namespace infra::test
