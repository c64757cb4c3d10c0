// What the renderer refuses, with the place and what to do about it.
#include <gtest/gtest.h>

#include <sstream>

#include "common/test_files.h"
#include "scene_pieces.h"
#include "test_data.h"
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

TEST(BadInput, BodiesAndMedia) {
    expect_refusal("\nvoid dielectric m 0 0 5 1 1 1 0 0" + ball, 2, "refractive index must be above 0");
    expect_refusal("void dielectric m 0 0 5 1 1 1 1.5 -800" + ball, 1, "with its dispersion must be above 0");
    expect_refusal("void interface m 0 0 8 1 1 1 1.5 1 1 1 -1" + ball, 1, "refractive index must be above 0");
    expect_refusal("void mist m 0 0 4 1 1 1 1" + ball, 1, "4 real arguments where 0, 3, 6 or 7 are needed");
    std::string many = "void mist m 33";
    for (int i = 0; i < 33; ++i) many += " s";
    expect_refusal(many + " 0 0" + ball, 1, "more than 32 light sources");
    expect_refusal("void antimatter m 0 0 0" + ball, 1, "at least 1");
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

TEST(BadInput, TemperaturesAndBands) {
    expect_refusal("void thermal m 0 0 3 0 8 12" + ball, 1, "temperature 0 K is not above 0");
    expect_refusal("\nvoid thermal m 0 0 3 -20 8 12" + ball, 2, "temperature -20 K is not above 0");
    expect_refusal("void thermal m 0 0 3 300 12 8" + ball, 1, "12 to 8 um is not a band");
    expect_refusal("void thermal m 0 0 3 300 8000 12000" + ball, 1, "wavelengths in um from 0.2 to 1000");
    expect_refusal("void thermal m 0 0 4 300 8 12 1.2" + ball, 1, "emissivity 1.2 is not within 0..1");
    expect_refusal("void thermal m 0 0 2 300 8" + ball, 1, "2 real arguments where 3 or 4 are needed");
    expect_refusal("void glow lamp 0 0 4 1 1 1 0 void thermal m 1 lamp 0 3 300 8 12" + ball, 1,
                   "\"lamp\" emits by itself");
    expect_refusal("void emissive lamp 0 0 3 1 1 1 void thermal m 1 lamp 0 3 300 8 12" + ball, 1,
                   "\"lamp\" emits by itself");
    expect_refusal(
        "void plastic p 0 0 5 1 1 1 0 0 void thermal hot 1 p 0 3 400 8 12\n"
        "void mixfunc half 4 hot p .5 . 0 0 void thermal m 1 half 0 3 300 8 12" +
            ball,
        2, "\"half\" emits by itself");
    expect_refusal("void thermal hot 0 0 3 300 8 12 void thermal m 1 hot 0 3 300 8 12" + ball, 1,
                   "\"hot\" emits by itself");
}

TEST(BadInput, AirPathFiles) {
    RenderSettings settings;
    settings.air_path = "no_such.air";
    EXPECT_NE(refusal("void plastic m 0 0 5 1 1 1 0 0" + ball, settings).find("no_such.air"),
              std::string::npos);
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

TEST(BadInput, DataFilesAndPictures) {
    const test::TemporaryFolder folder;
    const test::DataFiles data = test::write_data(folder);
    const std::string pattern = "void brightdata f ", tail = " 0 0\nf plastic m 0 0 5 1 1 1 0 0" + ball;
    expect_refusal(pattern + "4 noop no_such.dat . Px" + tail, 1, "cannot find data file \"no_such.dat\"");
    expect_refusal(pattern + "4 noop " + data.map + " . Px" + tail, 1,
                   "4 string arguments where at least 5 are needed");
    expect_refusal(pattern + "5 nope " + data.map + " . Px Py" + tail, 1, "undefined function \"nope\"");
    expect_refusal(pattern + "5 red " + data.map + " . Px Py" + tail, 1,
                   "function \"red\" takes 3 arguments, here it is given 1");
    expect_refusal(pattern + "5 noop " + data.map + " no_such.cal Px Py" + tail, 1, "no_such.cal");
    expect_refusal(pattern + "5 noop " + data.map + " . Px (" + tail, 1, "syntax error");
    test::write_file(folder / "bad.dat", "1\n0 1 2\n3\n");
    const std::string bad = refusal(pattern + "4 noop " + (folder / "bad.dat") + " . Px" + tail);
    EXPECT_TRUE(bad.starts_with((folder / "bad.dat") + ":3: the file ends")) << bad;

    expect_refusal("void colordata f 9 noop noop noop " + data.map + " " + data.spectrum + " " + data.map +
                       " . Px Py" + tail,
                   1, "data files of 2 and 1 dimensions");
    expect_refusal("void colorpict f 7 red green blue no_such.hdr . Px Py" + tail, 1,
                   "cannot find picture \"no_such.hdr\"");
    const std::string picture = refusal("void colorpict f 7 red green blue " + data.map + " . Px Py" + tail);
    EXPECT_NE(picture.find("map.dat: cannot read picture"), std::string::npos) << picture;
}

TEST(BadInput, Spectra) {
    const test::TemporaryFolder folder;
    const test::DataFiles data = test::write_data(folder);
    const std::string tail = "\nf plastic m 0 0 5 1 1 1 0 0" + ball;
    expect_refusal("void spectrum f 0 0 4 380 780 1 1" + tail, 1, "4 real arguments where at least 5");
    expect_refusal("void spectrum f 0 0 5 380 380 1 1 1" + tail, 1, "not a range of wavelengths");
    expect_refusal("void spectrum f 0 0 5 -1 380 1 1 1" + tail, 1, "not a range of wavelengths");
    expect_refusal("void specfile f 1 no_such.dat 0 0" + tail, 1, "cannot find data file");
    expect_refusal("void specfile f 1 " + data.map + " 0 0" + tail, 1, "a data file of 2 dimensions");
    expect_refusal("void specfunc f 2 noop . 0 2 500 500" + tail, 1, "not a range of wavelengths");
    expect_refusal("void specfunc f 2 nope . 0 2 400 700" + tail, 1, "undefined function \"nope\"");
    expect_refusal("void specdata f 4 min " + data.spectrum + " . Px 0 0" + tail, 1,
                   "a data file of 1 dimension");
    expect_refusal("void specdata f 4 min " + data.map + " . Px 0 0" + tail, 1,
                   "0 to 2 is not a range of wavelengths");
    expect_refusal("void specpict f 5 min no_such.hsr . Px Py 0 0" + tail, 1,
                   "cannot find spectral picture \"no_such.hsr\"");
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

TEST(BadInput, OrientedMaterials) {
    expect_refusal("void plastic2 m 4 1 0 0 . 0 6 1 1 1 .1 0 .2" + ball, 1, "roughness too small");
    expect_refusal("void trans2 m 4 1 0 0 . 0 8 1 1 1 .1 .2 -.2 .5 .5" + ball, 1, "roughness too small");
    expect_refusal("void metal2 m 3 1 0 0 0 6 1 1 1 .1 .1 .2" + ball, 1, "where at least 4 are needed");
    expect_refusal("void metal2 m 4 1 0 0 no_such.cal 0 6 1 1 1 .1 .1 .2" + ball, 1, "no_such.cal");
    expect_refusal("void metal2 m 5 1 0 0 . -rx 0 6 1 1 1 .1 .1 .2" + ball, 1, "bad transform");
    expect_refusal("void ashik2 m 4 1 0 0 . 0 8 .1 .1 .1 .1 .1 .1 -1 5" + ball, 1, "must not be negative");
}

TEST(BadInput, Texts) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "good.fnt", "65 3 0 0 255 0 128 255\n");
    test::write_file(folder / "bad.fnt", "65 3 0 0 255 0 128 255\n65 0\n");
    const std::string font = folder / "good.fnt", steps = " 0 11 0 0 0 1 0 0 0 -1 0 1 .5",
                      tail = " t plastic m 0 0 5 1 1 1 0 0" + ball;
    expect_refusal("void brighttext t 3 no_such.fnt . A" + steps + tail, 1,
                   "cannot find font \"no_such.fnt\"");
    expect_refusal("void brighttext t 2 " + font + " no_such.txt" + steps + tail, 1,
                   "cannot find text file \"no_such.txt\"");
    expect_refusal("void brighttext t 3 " + font + " . A 0 10 0 0 0 1 0 0 0 -1 0 1" + tail, 1,
                   "10 real arguments");
    expect_refusal("void brighttext t 3 " + font + " . A 0 11 0 0 0 1 0 0 2 0 0 1 .5" + tail, 1,
                   "illegal motion vector");
    expect_refusal("void brighttext t 3 " + font + " . A 0 12 0 0 0 1 0 0 0 -1 0 1 .5 1e30" + tail, 1,
                   "line of text is too long");
    expect_refusal("void mixtext m 5 a void " + font + " . A 0 9 0 0 0 1 0 0 0 -1 0" + ball, 1,
                   "undefined modifier \"a\"");
    const std::string message =
        refusal("void brighttext t 3 " + (folder / "bad.fnt") + " . A" + steps + tail);
    EXPECT_NE(message.find("bad.fnt:2: character 65 stands twice"), std::string::npos) << message;
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
