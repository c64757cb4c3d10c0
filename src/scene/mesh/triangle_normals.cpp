#include "scene/mesh/triangle_normals.h"

#include <algorithm>

namespace infra {

TriangleNormals compare_normals(const Vec3& own, const std::array<Vec3, 3>& at_corners) {
    constexpr double flat_cosine = 0.999995;
    const double cosines[] = {dot(own, at_corners[0]), dot(own, at_corners[1]), dot(own, at_corners[2])};
    const auto [least, most] = std::ranges::minmax(cosines);
    const bool turned = most < 0;
    return {turned, (turned ? -most : least) < flat_cosine};
}

}  // namespace infra
