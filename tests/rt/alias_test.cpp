// Aliases through the tracer: what a surface wears under an alias of an alias. RADIANCE 6.1 gives the same
// values for this scene.
#include <gtest/gtest.h>

#include "traced_scene.h"

namespace infra {
namespace {

TEST(Alias, KeepsItsMaterialThroughOtherAliases) {
    test::TracedScene scene(
        "void brightfunc half 2 .5 . 0 0\n"
        "void glow red 0 0 4 1 0 0 0\n"
        "half alias r1 red\n"
        "inherit alias r2 r1\n"
        "void alias r3 r2\n"
        "void alias r4 r1\n"
        "r1 sphere a 0 0 4 0 0 0 1\n"
        "r2 sphere b 0 0 4 5 0 0 1\n"
        "r3 sphere c 0 0 4 10 0 0 1\n"
        "r4 sphere d 0 0 4 15 0 0 1\n");
    const float expected[] = {0.5f, 0.5f, 1.0f, 1.0f};
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(scene.radiance({5.0 * i, 0, 5}, {0, 0, -1})[0], expected[i]) << "sphere " << i;
}

}  // namespace
}  // namespace infra
