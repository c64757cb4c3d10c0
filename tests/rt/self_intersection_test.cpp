// Rays that leave a surface do not meet it again where they started, however far from the origin it lies.
#include <gtest/gtest.h>

#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

const Vec3 offsets[] = {{0, 0, 0}, {1e3, -2e3, 3e3}, {1.1e5, 2.3e5, -0.7e5}};

std::string text_of(const Vec3& v) { return words(v.x, v.y, v.z); }

// A white object in a surrounding of radiance 1: any ray that is caught by its own surface is missing.
void expect_white(const std::string& shape, const Vec3& target, const Vec3& normal) {
    test::TracedScene scene("void plastic m 0 0 5 1 1 1 0 0\n" + shape + test::surrounding(1),
                            test::bounce_settings(256));
    const Vec3 from = target + normal * 2.0 + cross(normal, Vec3{0.3, 0.5, 0.1});
    const test::Estimate seen = scene.mean_radiance(40, from, target - from);
    EXPECT_NEAR(seen.mean, 1, 1e-5) << shape;
}

TEST(SelfIntersection, FlatSurfacesDoNotShadeThemselves) {
    for (const Vec3& offset : offsets) {
        const Vec3 normal = normalize(Vec3{0.2, -0.4, 0.9});
        Vec3 u, v;
        make_frame(normal, u, v);
        expect_white("m ring r 0 0 8 " + text_of(offset) + text_of(normal) + "0 3\n", offset, normal);
        const std::string corners[] = {text_of(offset + u * 3.0), text_of(offset - u * 2.0 + v * 2.0),
                                       text_of(offset - u * 2.0 - v * 2.5), text_of(offset + u - v * 2.5)};
        expect_white("m polygon p 0 0 9 " + corners[0] + corners[1] + corners[2] + "\n", offset, normal);
        expect_white("m polygon p 0 0 12 " + corners[0] + corners[1] + corners[2] + corners[3] + "\n", offset,
                     normal);
    }
}

TEST(SelfIntersection, RoundSurfacesDoNotShadeThemselves) {
    for (const Vec3& offset : offsets) {
        const Vec3 top{0, 0, 1};
        expect_white("m sphere s 0 0 4 " + text_of(offset) + "1\n", offset + top, top);
        expect_white(
            "m cylinder c 0 0 7 " + text_of(offset - Vec3{5, 0, 0}) + text_of(offset + Vec3{5, 0, 0}) + "1\n",
            offset + top, top);
    }
}

// A hollow sphere must meet itself: from inside nothing of the surrounding is seen.
TEST(SelfIntersection, HollowShapesMeetThemselves) {
    for (const Vec3& offset : offsets) {
        test::TracedScene scene("void plastic m 0 0 5 1 1 1 0 0\nm bubble b 0 0 4 " + text_of(offset) +
                                    "1\n" + test::surrounding(1),
                                test::bounce_settings(256));
        EXPECT_EQ(scene.mean_radiance(40, offset, {0.6, 0, 0.8}).mean, 0) << text_of(offset);
    }
}

}  // namespace
}  // namespace infra
