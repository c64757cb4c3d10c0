// Which of two surfaces in the same place is seen: a material over none, opaque over transparent, the front
// over the back, the later modifier over the earlier.
#include <gtest/gtest.h>

#include "scene_pieces.h"

namespace infra {
namespace {

const std::string up = " polygon p 0 0 12 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n";
const std::string down = " polygon p 0 0 12 -1 -1 0 -1 1 0 1 1 0 1 -1 0\n";
const std::string materials =
    "void plastic first 0 0 5 .5 .5 .5 0 0\n"
    "void plastic second 0 0 5 .5 .5 .5 0 0.1\n"
    "void trans sheet 0 0 7 .5 .5 .5 0 0 .5 .5\n"
    "void glass pane 0 0 3 .9 .9 .9\n";

// Modifier of the surface that a ray from above meets.
std::string seen(const std::string& surfaces, const Vec3& origin = {0.1, 0.2, 2}) {
    test::TracedScene scene(materials + surfaces);
    const Ray ray = scene.tracer().primary(origin, {0, 0, -1}, 0);
    Interaction at(ray);
    scene.tracer().cast(at);
    return at.hit() ? std::string(scene.compiled().modifier_name(at.surface)) : "nothing";
}

TEST(CoincidentSurfaces, AMaterialWinsOverNone) {
    EXPECT_EQ(seen("first" + up + "void" + up), "first");
    EXPECT_EQ(seen("void" + up + "first" + up), "first");
    EXPECT_EQ(seen("void" + up + "first" + down), "first");
}

TEST(CoincidentSurfaces, OpaqueWinsOverTransparent) {
    EXPECT_EQ(seen("first" + up + "sheet" + up), "first");
    EXPECT_EQ(seen("sheet" + up + "first" + up), "first");
    EXPECT_EQ(seen("pane" + up + "first" + down), "first");
}

TEST(CoincidentSurfaces, TheFrontWinsOverTheBack) {
    EXPECT_EQ(seen("first" + up + "second" + down), "first");
    EXPECT_EQ(seen("second" + down + "first" + up), "first");
    EXPECT_EQ(seen("first" + down + "second" + up), "second");
}

TEST(CoincidentSurfaces, TheLaterModifierWins) {
    EXPECT_EQ(seen("first" + up + "second" + up), "second");
    EXPECT_EQ(seen("second" + up + "first" + up), "second");
}

TEST(CoincidentSurfaces, WithinAMillionthTheyAreOnePlace) {
    const std::string above = " polygon p 0 0 12 -1 -1 5e-7 1 -1 5e-7 1 1 5e-7 -1 1 5e-7\n";
    const std::string farther_above = " polygon p 0 0 12 -1 -1 5e-6 1 -1 5e-6 1 1 5e-6 -1 1 5e-6\n";
    EXPECT_EQ(seen("first" + above + "second" + up), "second");
    EXPECT_EQ(seen("first" + farther_above + "second" + up), "first");
}

TEST(CoincidentSurfaces, AmongManyShapesTheOrderOfTheWalkDoesNotMatter) {
    std::string many;
    for (int n = 0; n < 50; ++n)
        many += test::words(n % 2 ? "second" : "first", "ring r 0 0 8", 0.01 * n, 0, 0, "0 0", n % 3 ? 1 : -1,
                            "0 2\n");
    for (int n = 0; n < 20; ++n) EXPECT_EQ(seen(many, {0.05 * n - 0.5, 0.3, 2}), "second");
}

}  // namespace
}  // namespace infra
