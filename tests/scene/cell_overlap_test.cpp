#include "scene/cell_overlap.h"

#include <gtest/gtest.h>

#include "scene_text.h"

namespace infra {
namespace {

using test::scene_of;

Overlap overlap_of(const std::string& surface, const Cube& cell) {
    const Scene scene = scene_of("void " + surface);
    InstanceBoxes instances(scene);
    return CellOverlap(scene, instances, 1e-3)(0, cell);
}

bool touches(const std::string& surface, const Cube& cell) {
    return overlap_of(surface, cell) == Overlap::partial;
}

const Cube unit{Vec3(0), 1};

TEST(CellOverlap, Triangle) {
    EXPECT_TRUE(touches("polygon p 0 0 9 .5 .5 .5 3 0 0 0 3 0", unit));      // a corner inside
    EXPECT_TRUE(touches("polygon p 0 0 9 -9 -9 .5 9 -9 .5 0 9 .5", unit));   // cuts right through
    EXPECT_TRUE(touches("polygon p 0 0 9 -1 .5 .5 2 .5 .5 2 .5 9", unit));   // an edge through
    EXPECT_FALSE(touches("polygon p 0 0 9 2 0 0 3 0 0 2 1 0", unit));        // to one side
    EXPECT_FALSE(touches("polygon p 0 0 9 3.5 0 0 0 3.5 0 0 0 3.5", unit));  // plane beyond the far corner
    EXPECT_TRUE(touches("polygon p 0 0 9 2.9 0 0 0 2.9 0 0 0 2.9", unit));   // plane cuts that corner off
    EXPECT_FALSE(
        touches("polygon p 0 0 9 2.2 -.1 .5 -.1 2.2 .5 2.2 2.2 .5", unit));  // only an edge axis tells
}

TEST(CellOverlap, PolygonWithManyCorners) {
    EXPECT_TRUE(touches("polygon p 0 0 12 -9 -9 .5 9 -9 .5 9 9 .5 -9 9 .5", unit));
    EXPECT_FALSE(touches("polygon p 0 0 12 -9 -9 1.5 9 -9 1.5 9 9 1.5 -9 9 1.5", unit));
    EXPECT_FALSE(touches("polygon p 0 0 12 2 -1 .5 3 -1 .5 3 9 .5 2 9 .5", unit));
}

TEST(CellOverlap, SphereIsHollow) {
    EXPECT_TRUE(touches("sphere s 0 0 4 .5 .5 .5 .1", unit));
    EXPECT_TRUE(touches("sphere s 0 0 4 -1 .5 .5 1.1", unit));
    EXPECT_FALSE(touches("sphere s 0 0 4 -1 .5 .5 .9", unit));
    EXPECT_FALSE(touches("sphere s 0 0 4 -1 -1 -1 1.7", unit));  // its box touches, it does not
    EXPECT_FALSE(touches("bubble s 0 0 4 .5 .5 .5 .9", unit));   // the cell lies within
    EXPECT_TRUE(touches("bubble s 0 0 4 .5 .5 .5 .86", unit));
    EXPECT_TRUE(touches("sphere s 0 0 4 .5 .5 .5 -.1", unit));
}

TEST(CellOverlap, TurnedLines) {
    EXPECT_TRUE(touches("cylinder c 0 0 7 .5 .5 -9 .5 .5 9 .2", unit));
    EXPECT_FALSE(touches("cylinder c 0 0 7 .5 .5 -9 .5 .5 9 2", unit));  // the cell lies within
    EXPECT_FALSE(touches("cylinder c 0 0 7 .5 .5 2 .5 .5 9 .2", unit));
    EXPECT_TRUE(touches("cone c 0 0 8 .5 .5 -1 .5 .5 2 0 2", unit));
    EXPECT_TRUE(touches("cone c 0 0 8 .5 .5 2 .5 .5 -1 2 0", unit));
    EXPECT_FALSE(touches("cone c 0 0 8 .5 .5 3 .5 .5 9 0 2", unit));
    EXPECT_TRUE(touches("ring r 0 0 8 .5 .5 .5 0 0 1 0 9", unit));
    EXPECT_FALSE(touches("ring r 0 0 8 .5 .5 .5 0 0 1 2 9", unit));  // the cell lies in its hole
    EXPECT_FALSE(touches("ring r 0 0 8 .5 .5 1.2 0 0 1 0 9", unit));
    EXPECT_TRUE(touches("ring r 0 0 8 0 0 0 1 1 1 0 .01", unit));
}

TEST(CellOverlap, SourcesHaveNoPlace) {
    EXPECT_EQ(overlap_of("source s 0 0 4 0 0 1 5", unit), Overlap::none);
}

TEST(CellOverlap, Instance) {
    const std::string ball = "instance i 7 " INFRA_SOURCE_DIR "/tests/data/ball_frozen.oct ";  // cube -1..1
    EXPECT_EQ(overlap_of(ball + "-rx 0 -t 5 0 0 0 0", unit), Overlap::none);
    EXPECT_EQ(overlap_of(ball + "-rx 0 -t 1.5 0 0 0 0", unit), Overlap::partial);
    EXPECT_EQ(overlap_of(ball + "-s 9 -t 0 0 0 0 0", unit), Overlap::contained);
    EXPECT_EQ(overlap_of(ball + "-rz 45 -t 2.5 .5 0 0 0", unit), Overlap::none);
    EXPECT_EQ(overlap_of(ball + "-rz 45 -t 2.3 .5 0 0 0", unit), Overlap::partial);
}

}  // namespace
}  // namespace infra
