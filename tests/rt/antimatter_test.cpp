// Volumes taken out of others.
#include <gtest/gtest.h>

#include "traced_scene.h"

namespace infra {
namespace {

const std::string back = "void glow far 0 0 4 7 7 7 0 far polygon wall 0 0 12 -9 9 -9 9 9 -9 9 9 9 -9 9 9\n";
const std::string ball =
    "void glow skin 0 0 4 1 1 1 0 void glow flesh 0 0 4 3 3 3 0 skin sphere ball 0 0 4 0 5 0 1\n";

float seen(const std::string& text) { return test::TracedScene(text).radiance({0, 0, 0}, {0, 1, 0})[0]; }

TEST(Antimatter, ThatIsVoidLeavesNothing) {
    EXPECT_EQ(seen(back + ball), 1.0f);
    const std::string cut = "void antimatter hole 2 void skin 0 0 hole sphere cut 0 0 4 0 5 0 1.5\n";
    EXPECT_EQ(seen(back + ball + cut), 7.0f);
}

TEST(Antimatter, ShowsTheFaceOfTheCut) {
    // A bite out of the front: its bottom lies within the ball.
    const std::string bite = "0 0 bite sphere cut 0 0 4 0 4 0 .8\n";
    EXPECT_EQ(seen(back + ball + "void antimatter bite 1 skin " + bite), 1.0f);
    EXPECT_EQ(seen(back + ball + "void antimatter bite 2 flesh skin " + bite), 3.0f);
    test::TracedScene scene(back + ball + "void antimatter bite 2 flesh skin " + bite);
    const Ray ray = scene.tracer().primary({0, 0, 0}, {0, 1, 0}, 0);
    Interaction at(ray);
    scene.tracer().trace(at);
    EXPECT_NEAR(at.distance + 1.6, at.direct_distance, 1e-6);
}

TEST(Antimatter, LeavesOtherSurfacesAlone) {
    const std::string pip = "void glow core 0 0 4 5 5 5 0 core sphere pip 0 0 4 0 4.5 0 .1\n";
    const std::string cut = "void antimatter hole 1 skin 0 0 hole sphere cut 0 0 4 0 5 0 1.5\n";
    EXPECT_EQ(seen(back + ball + pip + cut), 5.0f);
}

TEST(Antimatter, OpensTheWayForShadowRays) {
    const std::string lamp = "void light lum 0 0 3 100 100 100 lum sphere lamp 0 0 4 0 5 9 .1\n";
    const std::string floor = "void plastic white 0 0 5 1 1 1 0 0 white ring floor 0 0 8 0 5 -3 0 0 1 0 2\n";
    const std::string block = "void plastic skin 0 0 5 .5 .5 .5 0 0 skin sphere ball 0 0 4 0 5 0 1\n";
    const std::string hole =
        "void antimatter hole 2 void skin 0 0 hole cylinder cut 0 0 7 0 5 -2 0 5 2 .8 "
        "hole ring c0 0 0 8 0 5 -2 0 0 -1 0 .8 hole ring c1 0 0 8 0 5 2 0 0 1 0 .8\n";
    const auto lit = [&](const std::string& text) {
        return test::TracedScene(lamp + floor + text)
            .radiance({1, 2, -2}, Vec3{-1, 3, -1} / std::sqrt(11.0))[0];
    };
    EXPECT_EQ(lit(block), 0.0f);
    EXPECT_GT(lit(""), 0.0f);
    EXPECT_EQ(lit(block + hole), lit(""));
}

TEST(Antimatter, WarnsOfNamesThatAreNoModifiers) {
    test::TracedScene scene(back + ball +
                            "void antimatter hole 4 void skn skin skin 0 0 hole sphere cut 0 0 4 0 5 0 2\n");
    const auto& warnings = scene.compiled().warnings();
    ASSERT_GE(warnings.size(), 2u);
    EXPECT_NE(warnings[0].find("unknown modifier \"skn\""), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find("duplicate modifier \"skin\""), std::string::npos) << warnings[1];
}

TEST(Antimatter, WithoutAModifierForItsFaceLetsOneLookIntoTheBody) {
    const std::string cut = " 0 0 hole sphere cut 0 0 4 0 4 0 .8\n";
    for (const char* name : {"nobody", "void"})
        EXPECT_EQ(seen(back + ball + "void antimatter hole 2 " + name + " skin" + cut), 0.0f)
            << "the far side from behind is black";
}

}  // namespace
}  // namespace infra
