// The rays of the intersection benchmark: what a renderer asks of a scene, each kind by itself.
#pragma once

#include <string>
#include <vector>

#include "common/vec.h"
#include "rt/geometry/geometry.h"

namespace infra::bench {

struct TestRay {
    Vec3 origin, direction;
    PlacedShape leaving;
    double length;  ///< for occlusion: nothing beyond is asked for
};

struct RaySet {
    std::string name;
    std::vector<TestRay> rays;
};

/// random: from anywhere in the scene's box, anywhere. bounce: from where random rays hit, by the cosine.
/// hemisphere: 1024 by the cosine from each of a few hits. camera: a picture from ahead of the scene, row by
/// row.
std::vector<RaySet> make_ray_sets(const Geometry& geometry, std::size_t count);

}  // namespace infra::bench
