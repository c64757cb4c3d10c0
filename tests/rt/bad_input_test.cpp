// What the renderer refuses, with the place and what to do about it.
#include <gtest/gtest.h>

#include <sstream>

#include "common/test_files.h"
#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

// The message for a scene of which only the first surface matters.
std::string refusal(const std::string& text, const RenderSettings& settings = {}) {
    return test::error_of([&] { test::TracedScene scene(text, settings); });
}

void expect_refusal(const std::string& text, int line, const std::string& what) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("test.rad:" + std::to_string(line) + ":")) << message;
    EXPECT_NE(message.find(what), std::string::npos) << message << "\nwanted: " << what;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
}

const std::string ball = "\nm sphere ball 0 0 4 0 0 0 1\n";

TEST(BadInput, TypesWithoutShading) {
    expect_refusal("\nvoid dielectric m 0 0 5 1 1 1 1.5 0" + ball, 2,
                   "type \"dielectric\" is not supported yet");
    expect_refusal("void mist m 0 0 0" + ball, 1, "type \"mist\" is not supported yet");
}

TEST(BadInput, UnusedDefinitionsMayBeAnything) {
    EXPECT_EQ(
        refusal("void dielectric unused 0 0 5 1 1 1 1.5 0\nvoid nrlbrdf other 1 no_such.brdf 0 5 1 1 1 1 1\n"
                "void plastic m 0 0 5 .5 .5 .5 0 0" +
                ball),
        "no error");
}

TEST(BadInput, ArgumentCountsOfModifiersInUse) {
    expect_refusal("void plastic m 0 0 4 .5 .5 .5 0" + ball, 1, "4 real arguments where 5 are needed");
    expect_refusal("void emissive m 2 a b 0 3 1 1 1" + ball, 1, "string arguments where 0 or 1 are needed");
    expect_refusal("void nrlbrdf m 1 x.brdf 0 6 1 1 1 1 .3 1" + ball, 1,
                   "6 real arguments where 5 or 8 are needed");
    expect_refusal("void brightfunc f 1 x 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball, 1,
                   "where at least 2 are needed");
}

TEST(BadInput, NamesOfModifiersInArguments) {
    expect_refusal("void plastic paint 0 0 5 .5 .5 .5 0 0\nvoid emissive m 1 pant 0 3 1 1 1" + ball, 2,
                   "undefined modifier \"pant\"");
    EXPECT_NE(refusal("void plastic paint 0 0 5 .5 .5 .5 0 0\nvoid emissive m 1 pant 0 3 1 1 1" + ball)
                  .find("did you mean \"paint\"?"),
              std::string::npos);
    expect_refusal("void mixfunc m 4 a b .5 . 0 0" + ball, 1, "undefined modifier \"a\"");
    expect_refusal("void brightfunc f 2 1 . 0 0\nvoid emissive m 1 f 0 3 1 1 1" + ball, 2,
                   "\"f\" is not a material");
    expect_refusal("void emissive m 1 m 0 3 1 1 1" + ball, 1, "undefined modifier \"m\"");
}

TEST(BadInput, ConflictingMaterials) {
    expect_refusal("void plastic under 0 0 5 .5 .5 .5 0 0\n\nunder plastic m 0 0 5 .5 .5 .5 0 0" + ball, 3,
                   "conflicting material \"under\"");
    expect_refusal("void plastic under 0 0 5 .5 .5 .5 0 0\nunder emissive m 0 0 3 1 1 1" + ball, 2,
                   "conflicting material \"under\"");
}

TEST(BadInput, FunctionFiles) {
    expect_refusal("void brightfunc f 2 x no_such.cal 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball, 1,
                   "no_such.cal");
    const test::TemporaryFolder folder;
    test::write_file(folder / "bad.cal", "x = 1;\ny = (2 + ;\n");
    const std::string message =
        refusal("void brightfunc f 2 y " + (folder / "bad.cal") + " 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball);
    EXPECT_NE(message.find("bad.cal:2:"), std::string::npos) << message;
    expect_refusal("void brightfunc f 2 (1+ . 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball, 1, "syntax error");
    expect_refusal("void brightfunc f 4 1 . -rx turn 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball, 1,
                   "bad transform");
}

// Only a branch that is reached needs its names, as in RADIANCE: found when a ray gets there.
TEST(BadInput, NamesWithoutDefinitionInFunctions) {
    test::TracedScene scene("\nvoid brightfunc f 2 if(Pz,nowhere,1) . 0 0\nf plastic m 0 0 5 1 1 1 0 0" +
                            ball + test::surrounding(1));
    EXPECT_EQ(test::error_of([&] { scene.radiance({0, 0, -3}, {0, 0, 1}); }), "no error");
    const std::string message = test::error_of([&] { scene.radiance({0, 0, 3}, {0, 0, -1}); });
    EXPECT_TRUE(message.starts_with("test.rad:2:")) << message;
    EXPECT_NE(message.find("undefined variable \"nowhere\""), std::string::npos) << message;
}

TEST(BadInput, Tables) {
    const test::TemporaryFolder folder;
    const std::string good = test::write_tables(folder).front().path;
    expect_refusal("void nrlbrdf m 1 no_such.brdf 0 5 1 1 1 1 .3" + ball, 1,
                   "cannot find BRDF table \"no_such.brdf\"");
    expect_refusal("void nrlbrdf m 1 " + good + " 0 5 1 1 1 0 .3" + ball, 1, "nsamp must be at least 1");
    expect_refusal("void nrlbrdf m 1 " + good + " 0 5 1 1 1 1 0" + ball, 1, "alpha must lie in 0..1");
    expect_refusal("void nrlbrdf m 1 " + good + " 0 5 1 1 1 1 1.01" + ball, 1, "alpha must lie in 0..1");
    expect_refusal("void nrlbrdf m 1 " + good + " 0 5 -1 1 1 1 .3" + ball, 1, "must not be negative");
    test::write_file(folder / "bad.brdf", "2 2 2\n.1\n.1 .1 .1\n-.1 .1 .1 .1 .1\n");
    const std::string message =
        refusal("void nrlbrdf m 1 " + (folder / "bad.brdf") + " 0 5 1 1 1 1 .3" + ball);
    EXPECT_NE(message.find("bad.brdf:4: "), std::string::npos) << message;
}

TEST(BadInput, ATableThatReflectsTooMuchIsWarnedOf) {
    const test::TemporaryFolder folder;
    write_table(folder / "bright.brdf", tabulate(lambertian(1.2)));
    test::TracedScene scene("void nrlbrdf m 1 " + (folder / "bright.brdf") + " 0 5 1 1 1 1 .3" + ball);
    ASSERT_FALSE(scene.compiled().warnings().empty());
    EXPECT_NE(scene.compiled().warnings().front().find("bright.brdf:"), std::string::npos);
}

TEST(BadInput, LightSources) {
    const std::string lamp = "void light m 0 0 3 1 1 1\n";
    expect_refusal(lamp + "m cone c 0 0 8 0 0 0 0 0 1 1 0", 2, "a cone cannot be a light source");
    expect_refusal(lamp + "m bubble b 0 0 4 0 0 0 1", 2, "a bubble cannot be a light source");
    expect_refusal(lamp + "m ring r 0 0 8 0 0 0 0 0 1 .5 1", 2, "cannot be a ring with a hole");
    expect_refusal(lamp + "m source s 0 0 4 0 0 0 5", 2, "source direction is zero");
    expect_refusal(lamp + "m source s 0 0 4 0 0 1 0", 2, "source angle must be above 0");
    expect_refusal(lamp + "m polygon p 0 0 18 0 0 0 3 0 0 3 3 0 2.9 3 0 2.9 .1 0 0 .1 0", 2,
                   "does not contain its own centre");
    expect_refusal("void spotlight m 0 0 7 1 1 1 0 0 0 1" + ball, 1, "angle must be above 0");
    expect_refusal("void spotlight m 0 0 7 1 1 1 20 0 0 0" + ball, 1, "direction is zero");
}

TEST(BadInput, GlassThinnerThanAir) {
    expect_refusal("void glass m 0 0 4 1 1 1 .9" + ball, 1, "refractive index must be at least 1");
}

TEST(BadInput, SettingsThatWouldNeverEnd) {
    RenderSettings endless;
    endless.max_reflections = 0;
    endless.min_weight = 0;
    EXPECT_NE(refusal("void plastic m 0 0 5 .5 .5 .5 0 0" + ball, endless).find("-lw"), std::string::npos);
}

// Two mirrors face to face, and a mirror ball around the viewer: rays without end end.
TEST(BadInput, RaysBetweenPerfectMirrorsEnd) {
    for (const int reflections : {0, -8, 7}) {
        RenderSettings settings;
        settings.max_reflections = reflections;
        settings.min_weight = 1e-4;
        test::TracedScene scene("void metal m 0 0 5 1 1 1 1 0\nm bubble b 0 0 4 0 0 0 1\n", settings);
        EXPECT_EQ(scene.radiance({0.1, 0.2, 0.3}, normalize(Vec3{1, 2, 3}))[0], 0.0f);
    }
    test::TracedScene clear("void glass m 0 0 3 1 1 1\nm bubble b 0 0 4 0 0 0 1\n", test::path_settings());
    EXPECT_EQ(clear.radiance({0.1, 0.2, 0.3}, normalize(Vec3{1, 2, 3}))[0], 0.0f);
}

}  // namespace
}  // namespace infra
