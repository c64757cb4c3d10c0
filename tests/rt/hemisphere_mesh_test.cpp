// Derivatives of the share of a hemisphere that shapes fill, against differences of Lambert's formula.
#include "rt/ambient/hemisphere_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "common/random.h"
#include "rt/ambient/cosine_direction.h"

namespace infra {
namespace {

/// Share of the hemisphere around z that a polygon fills, seen from `eye`.
double share(const std::vector<Vec3>& corners, const Vec3& eye) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = corners[i] - eye, b = corners[(i + 1) % corners.size()] - eye;
        const Vec3 c = cross(a, b);
        sum += std::atan2(length(c), dot(a, b)) * c.z / length(c);
    }
    return sum / (2 * std::numbers::pi);
}

TEST(HemisphereMesh, EdgesGiveTheDerivativesOfAPolygonsShare) {
    constexpr double step = 1e-3;
    RandomStream random(7, 0);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Vec3> corners;
        const double height = 0.5 + random.uniform();
        for (int i = 0; i < 3; ++i)
            corners.emplace_back(3 * random.uniform() - 1.5, 3 * random.uniform() - 1.5,
                                 height + random.uniform());
        ShareDerivatives sum;
        for (int i = 0; i < 3; ++i) sum.add(edge_derivatives(corners[i], corners[(i + 1) % 3]), 1);
        const auto at = [&](double x, double y) { return share(corners, Vec3(x * step, y * step, 0)); };
        EXPECT_NEAR(sum.x, (at(1, 0) - at(-1, 0)) / (2 * step), 1e-5);
        EXPECT_NEAR(sum.y, (at(0, 1) - at(0, -1)) / (2 * step), 1e-5);
        EXPECT_NEAR(sum.xx, (at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (step * step), 1e-4);
        EXPECT_NEAR(sum.yy, (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (step * step), 1e-4);
        EXPECT_NEAR(sum.xy, (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * step * step), 1e-4);
    }
}

TEST(HemisphereMesh, AnEdgeSeenEndOnAddsNothing) {
    const ShareDerivatives none = edge_derivatives({1, 1, 1}, {2, 2, 2});
    EXPECT_EQ(none.x, 0);
    EXPECT_EQ(none.xx, 0);
}

/// A round room of radius 2 and height 1 as a hemisphere of rays in its middle sees it.
std::vector<MeshCorner> seen(int n, double value_left, double value_right) {
    std::vector<MeshCorner> corners;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec3 way = cosine_direction((i + 0.5) / n, (j + 0.5) / n);
            const double distance = std::min(1 / way.z, 2 / std::hypot(way.x, way.y));
            const Vec3 place = way * distance;
            corners.push_back({place, 1 / distance, place.x < 0 ? value_left : value_right});
        }
    return corners;
}

TEST(HemisphereMesh, EvenLightDoesNotChange) {
    const MeshDerivatives mesh = mesh_derivatives(16, seen(16, 1, 1));
    EXPECT_EQ(mesh.inner.x, 0);
    EXPECT_EQ(mesh.inner.xx, 0);
    EXPECT_EQ(mesh.skirt.x, 0);
    EXPECT_EQ(mesh.skirt.xx, 0);
    EXPECT_NEAR(mesh.shape.xx, mesh.rim.xx, 1e-12);
}

// All that lies at x < 0 has value 0, the rest 2: what counts is the rim of that rest, up one wall, along the
// ceiling, down the other wall and back along the horizon.
TEST(HemisphereMesh, MovingTowardsABrightHalfOfTheRoom) {
    const Vec3 around[] = {{0, 2, 0}, {0, 2, 1}, {0, -2, 1}, {0, -2, 0}, {2, 0, 0}};
    ShareDerivatives expected;
    for (int i = 0; i < 5; ++i) expected.add(edge_derivatives(around[i], around[(i + 1) % 5]), 2);
    const MeshDerivatives mesh = mesh_derivatives(64, seen(64, 0, 2));
    EXPECT_NEAR(mesh.inner.x + mesh.skirt.x, expected.x, 0.02 * expected.x);
    EXPECT_NEAR(mesh.inner.y + mesh.skirt.y, 0, 0.01);
    EXPECT_NEAR(mesh.inner.xx + mesh.skirt.xx, expected.xx, 0.1);
}

TEST(HemisphereMesh, BendHasItsStrongestDirectionFirst) {
    const Bend b = bend({.xx = 1, .xy = 0.5, .yy = -3});
    EXPECT_GT(b.strongest, b.weakest);
    const double along = b.cosine * b.cosine + 2 * 0.5 * b.cosine * b.sine - 3 * b.sine * b.sine;
    EXPECT_NEAR(std::fabs(along), b.strongest, 1e-12);
    EXPECT_NEAR(b.strongest * b.weakest, 3 + 0.25, 1e-12);
    EXPECT_NEAR(std::hypot(b.cosine, b.sine), 1, 1e-12);
}

}  // namespace
}  // namespace infra
