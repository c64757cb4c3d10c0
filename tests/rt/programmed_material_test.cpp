// plasfunc, metfunc, transfunc, plasdata, metdata, transdata and BRTDfunc against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "common/planck/planck.h"
#include "common/test_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
using test::words;

constexpr double pi = std::numbers::pi;
constexpr double sun_radiance = 5000;
const Vec3 sun_direction = test::direction(35 * degree, 0.9);
const double sun_omega = 2 * pi * (1 - std::cos(1 * degree));  // RADIANCE's, of a disk of 2 degrees

const char* const functions = R"(
white(x,y,z) = 1/PI;
mx = Dx + 2*RdotP*NxP;  my = Dy + 2*RdotP*NyP;  mz = Dz + 2*RdotP*NzP;
phong(x,y,z) = (A5 + 2)/(2*PI) * noneg(mx*x + my*y + mz*z)^A5;
size(x,y,z,omega) = 1000*omega;
along(x,y,z) = x;
height(x,y,z) = abs(z);
shading(x,y,z) = noneg(NxP*x + NyP*y + NzP*z) * CgP;
sides(x,y,z) = if(NxP*x + NyP*y + NzP*z, .1, .4);
front_or_back(x,y,z) = if(Rdot, .1, .3);
red(x,y,z) = CrP;
green(x,y,z) = CgP;
blue(x,y,z) = CbP;
nowhere(x,y,z) = sqrt(-z*z - 1);
ramp(x,y,z) = .2 + .6*abs(z);
scaled(v,x,y,z) = v*(1 + x);
scaled_ramp(x,y,z) = (.2 + .6*abs(z))*(1 + x);
)";

class ProgrammedMaterial : public testing::Test {
  protected:
    void SetUp() override {
        test::write_file(file_, functions);
        test::write_file(folder_ / "ramp.dat", "1\n0 1 2\n.2 .8\n");
    }

    /// A modifier "m" with these string arguments; FILE stands for the function file, DATA for the data file.
    std::string material(std::string text) const {
        for (const auto& [word, path] : {std::pair{"FILE", file_}, {"DATA", folder_ / "ramp.dat"}})
            for (auto at = text.find(word); at != std::string::npos; at = text.find(word))
                text.replace(at, 4, path);
        return text;
    }
    static std::string sun(const Vec3& d = sun_direction) {
        return words("\nvoid light sunlight 0 0 3", sun_radiance, sun_radiance, sun_radiance,
                     "sunlight source sun 0 0 4", d.x, d.y, d.z, "2\n");
    }
    /// The plate under the sun, its radiance over the sun's irradiance on a plane across it: f cos.
    std::vector<double> response(const std::string& text, const Vec3& to_viewer,
                                 const Vec3& to_sun = sun_direction, const Channels& channels = {}) const {
        test::TracedScene scene(material(text) + test::plate + sun(to_sun), {}, channels);
        const Spectrum seen = scene.radiance(to_viewer * 3.0, -to_viewer);
        std::vector<double> result;
        for (int c = 0; c < seen.channels(); ++c)
            result.push_back(double(seen[c]) / (sun_radiance * sun_omega));
        return result;
    }
    void expect_response(const std::string& text, const Vec3& to_viewer, const std::vector<double>& expected,
                         const Vec3& to_sun = sun_direction) const {
        const std::vector<double> values = response(text, to_viewer, to_sun);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(values[c], expected[c], 3e-6 * (1 + expected[c])) << text << " channel " << c;
    }
    std::string refusal(const std::string& text) const {
        return test::error_of([&] { test::TracedScene scene(material(text) + test::plate); });
    }

    test::TemporaryFolder folder_;
    std::string file_ = folder_ / "test.cal";
    const Vec3 viewer_ = test::direction(40 * degree, 0.9 + pi);  // near the sun's mirror image
};

TEST_F(ProgrammedMaterial, WhiteHighlightsAreWhitePlasticAndMetalOfItsColor) {
    const double cosine = sun_direction.z;
    std::vector<double> plastic, metal;
    for (const double color : {0.5, 0.3, 0.1}) {
        plastic.push_back((color * 0.6 + 0.4) * cosine / pi);
        metal.push_back(color * cosine / pi);
    }
    for (const Vec3& viewer : {viewer_, test::direction(1.2, 3)}) {
        expect_response("void plasfunc m 2 white FILE 0 4 .5 .3 .1 .4", viewer, plastic);
        expect_response("void metfunc m 2 white FILE 0 4 .5 .3 .1 .4", viewer, metal);
    }
    expect_response("void plasfunc m 2 white FILE 0 4 .5 .3 .1 .4", -viewer_, plastic, -sun_direction);
}

TEST_F(ProgrammedMaterial, PhongsLobe) {
    const Vec3 mirrored{-viewer_.x, -viewer_.y, viewer_.z};
    const double lobe = 52 / (2 * pi) * std::pow(dot(mirrored, sun_direction), 50);
    std::vector<double> expected;
    for (const double color : {0.5, 0.3, 0.1})
        expected.push_back((color * 0.6 / pi + 0.4 * lobe) * sun_direction.z);
    expect_response("void plasfunc m 2 phong FILE 0 5 .5 .3 .1 .4 50", viewer_, expected);
    EXPECT_GT(lobe, 5);
}

TEST_F(ProgrammedMaterial, TheSolidAngleIsPassedAndDirectionsAreTransformed) {
    expect_response("void metfunc m 2 size FILE 0 4 1 1 1 1", viewer_,
                    std::vector<double>(3, 1000 * sun_omega * sun_direction.z));
    // Turned by 90 degrees the function's x is the scene's y, and scale does not matter
    expect_response("void metfunc m 6 along FILE -rz 90 -s 3 0 4 1 1 1 1", viewer_,
                    std::vector<double>(3, sun_direction.y * sun_direction.z));
}

TEST_F(ProgrammedMaterial, DataGivesWhatTheFunctionWould) {
    const std::string reals = " 0 4 .5 .3 .1 .4";
    const std::string sheet = " 0 6 .5 .3 .1 .2 .6 .7";
    for (const auto& [with_data, with_function, rest] : {std::tuple{"plasdata", "plasfunc", reals},
                                                         {"metdata", "metfunc", reals},
                                                         {"transdata", "transfunc", sheet}}) {
        const std::string by_data = words("void", with_data, "m"),
                          by_function = words("void", with_function, "m");
        for (const Vec3& to_sun : {sun_direction, -sun_direction}) {
            expect_response(by_data + "4 noop DATA FILE height" + rest, viewer_,
                            response(by_function + "2 ramp FILE" + rest, viewer_, to_sun), to_sun);
            expect_response(by_data + "6 scaled DATA FILE height -rz 30" + rest, viewer_,
                            response(by_function + "4 scaled_ramp FILE -rz 30" + rest, viewer_, to_sun),
                            to_sun);
        }
    }
}

TEST_F(ProgrammedMaterial, TexturesAndPatternsReachTheFunctions) {
    const Vec3 normal = normalize(Vec3{0.4, 0, 1});
    const double cosine = dot(normal, sun_direction);
    std::vector<double> expected;
    for (const double color : {0.5, 0.3, 0.1})
        expected.push_back(color * 0.8 * 0.6 * cosine / pi + 0.4 * cosine * cosine * 0.8 * 0.3);
    expect_response(
        "void texfunc bend 4 .4 0 0 . 0 0 bend brightfunc dim 2 .8 . 0 0\n"
        "dim plasfunc m 2 shading FILE 0 4 .5 .3 .1 .4",
        viewer_, expected);
}

// Both sides: what is transmitted has the colour, what is reflected has none.
TEST_F(ProgrammedMaterial, TransfuncByClosedForm) {
    const double rspec = 0.2, trans = 0.6 * (1 - rspec), tspec = 0.7;
    std::vector<double> above, below;
    for (const double color : {0.5, 0.3, 0.1}) {
        above.push_back((color * (1 - trans - rspec) / pi + rspec * 0.1) * sun_direction.z);
        below.push_back(color * trans * ((1 - tspec) / pi + tspec * 0.4) * sun_direction.z);
    }
    const std::string sheet = "void transfunc m 2 sides FILE 0 6 .5 .3 .1 .2 .6 .7";
    expect_response(sheet, viewer_, above);
    expect_response(sheet, -viewer_, below);
}

// The indirect calculation takes the function's part as diffuse: so does Kirchhoff's law.
TEST_F(ProgrammedMaterial, IndirectLightAndEmissionCountAllAsDiffuse) {
    const double black = band_radiance(300, 8, 12);
    for (const std::string type : {"void plasfunc skin 2 white FILE 0 4 .4 .4 .4 .3",
                                   "void metfunc skin 2 phong FILE 0 5 .4 .4 .4 .3 9",
                                   "void transfunc skin 2 sides FILE 0 6 .4 .4 .4 .2 .6 .7"}) {
        test::TracedScene scene(
            material(type) + " void thermal m 1 skin 0 3 300 8 12" + test::plate + test::surrounding(10),
            test::bounce_settings(16));
        EXPECT_NEAR(scene.radiance(viewer_ * 3.0, -viewer_)[0], 0.6 * black + 0.4 * 10, 1e-4) << type;
    }
}

TEST_F(ProgrammedMaterial, ADomainErrorLeavesTheFunctionOut) {
    expect_response("void plasfunc m 2 nowhere FILE 0 4 .5 .5 .5 .4", viewer_,
                    std::vector<double>(3, 0.5 * 0.6 / pi * sun_direction.z));
}

TEST_F(ProgrammedMaterial, CastsAFullShadow) {
    for (const char* sheet : {"void plasfunc pane 2 white FILE 0 4 .5 .5 .5 .4",
                              "void transfunc pane 2 white FILE 0 6 1 1 1 0 1 1"}) {
        test::TracedScene scene(material(sheet) + " pane ring roof 0 0 8 0 0 2 0 0 1 0 9\n" + sun());
        EXPECT_EQ(scene.irradiance({0, 0, 0}, {0, 0, 1}), 0) << sheet;
    }
}

TEST_F(ProgrammedMaterial, Refusals) {
    const auto expect = [&](const std::string& text, const std::string& what) {
        const std::string message = refusal(text);
        EXPECT_TRUE(message.starts_with("test.rad:1:")) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    expect("void plasfunc m 2 no_such FILE 0 4 1 1 1 .5", "undefined function \"no_such\"");
    expect("void plasfunc m 2 scaled_ramp no_such.cal 0 4 1 1 1 .5", "no_such.cal");
    expect("void plasfunc m 2 linterp . 0 3 1 1 1", "3 real arguments");
    expect("void transfunc m 1 white 0 6 1 1 1 .1 .1 .1", "string argument");
    expect("void plasfunc m 4 white FILE -rx x 0 4 1 1 1 .5", "bad transform");
    expect("void plasfunc m 2 hermite . 0 4 1 1 1 .5", "takes 5 arguments, here it is given 4");
    expect("void plasdata m 4 noop no_such.dat . height 0 4 1 1 1 .5", "no_such.dat");
    expect("void metdata m 3 noop DATA FILE 0 4 1 1 1 .5", "string arguments");
    expect("void metdata m 5 noop DATA FILE -rx 90 0 4 1 1 1 .5", "undefined function \"-rx\"");
    expect("void BRTDfunc m 10 0 0 0 0 0 0 missing 0 0 . 0 9 0 0 0 0 0 0 0 0 0",
           "undefined function \"missing\"");
    expect("void BRTDfunc m 10 0 0 0 0 0 (1 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0", "')'");
}

TEST_F(ProgrammedMaterial, OnlyTheseMaterialsHaveTheirVariables) {
    test::TracedScene scene("void brightfunc f 2 RdotP . 0 0 f plastic m 0 0 5 1 1 1 0 0" + test::plate);
    const std::string message = test::error_of([&] { scene.radiance({0, 0.5, 3}, {0, 0, -1}); });
    EXPECT_NE(message.find("RdotP"), std::string::npos) << message;
}

// BRTDfunc
// ---------------------------------------------------------------------------------------------------------

const std::string two_skies =
    "void glow high 0 0 4 3 5 7 0 high source up 0 0 4 0 0 1 180\n"
    "void glow low 0 0 4 10 20 30 0 low source down 0 0 4 0 0 -1 180\n";

TEST_F(ProgrammedMaterial, BrtdfuncIsAMirrorAndAPane) {
    test::TracedScene scene(
        "void BRTDfunc m 10 .5 .4 if(Rdot,.3,.1) .2 .3 .4*RdotP 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0" + test::plate +
        two_skies);
    const double cosine = viewer_.z;
    const Spectrum front = scene.radiance(viewer_ * 3.0, -viewer_);
    EXPECT_NEAR(front[0], 0.5 * 3 + 0.2 * 10, 1e-5);
    EXPECT_NEAR(front[1], 0.4 * 5 + 0.3 * 20, 1e-5);
    EXPECT_NEAR(front[2], 0.3 * 7 + 0.4 * cosine * 30, 1e-5);
    const Spectrum back = scene.radiance(viewer_ * -3.0, viewer_);
    EXPECT_NEAR(back[0], 0.5 * 10 + 0.2 * 3, 1e-5);
    EXPECT_NEAR(back[2], 0.1 * 30 + 0.4 * cosine * 7, 1e-5);
}

TEST_F(ProgrammedMaterial, BrtdfuncLetsLightThrough) {
    const std::string pane = "void BRTDfunc pane 10 0 0 0 .5*RdotP .25 0 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0\n";
    test::TracedScene scene(pane + "void plastic m 0 0 5 1 1 1 0 0\npane ring roof 0 0 8 0 0 2 0 0 1 0 9\n" +
                            test::plate + sun());
    const Spectrum seen = scene.radiance({0, 0, 1}, {0, 0, -1});
    const double open = sun_radiance * sun_omega * sun_direction.z / pi;
    EXPECT_NEAR(seen[0], 0.5 * sun_direction.z * open, 1e-5 * open);
    EXPECT_NEAR(seen[1], 0.25 * open, 1e-5 * open);
    EXPECT_EQ(seen[2], 0.0f);
    test::TracedScene opaque(
        "void BRTDfunc pane 10 1 1 1 0 0 0 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0\n"
        "pane ring roof 0 0 8 0 0 2 0 0 1 0 9\n" +
        sun());
    EXPECT_EQ(opaque.irradiance({0, 0, 0}, {0, 0, 1}), 0);
}

TEST_F(ProgrammedMaterial, BrtdfuncDiffuseOfFrontBackAndThrough) {
    const std::string sheet = "void BRTDfunc m 10 0 0 0 0 0 0 0 0 0 . 0 9 .1 .2 .3 .4 .5 .6 .05 .07 .09";
    const double scale = sun_direction.z / pi;
    expect_response(sheet, viewer_, {0.1 * scale, 0.2 * scale, 0.3 * scale});
    expect_response(sheet, -viewer_, {0.4 * scale, 0.5 * scale, 0.6 * scale}, -sun_direction);
    expect_response(sheet, -viewer_, {0.05 * scale, 0.07 * scale, 0.09 * scale});
    expect_response(sheet, viewer_, {0.05 * scale, 0.07 * scale, 0.09 * scale}, -sun_direction);
}

// The pattern colours the diffuse parts; the functions have to ask for it.
TEST_F(ProgrammedMaterial, BrtdfuncFunctions) {
    const std::string tint = "void colorfunc tint 4 .5 .6 .7 . 0 0 tint ";
    const double cosine = sun_direction.z;
    expect_response(tint + "BRTDfunc m 10 0 0 0 0 0 0 red sides sides FILE 0 9 .1 .1 .1 0 0 0 0 0 0", viewer_,
                    {(0.05 / pi + 0.5) * cosine, (0.06 / pi + 0.1) * cosine, (0.07 / pi + 0.1) * cosine});
    const std::string both = "void BRTDfunc m 10 0 0 0 0 0 0 0 front_or_back 0 FILE 0 9 0 0 0 0 0 0 0 0 0";
    expect_response(both, viewer_, {0, 0.1 * cosine, 0});
    expect_response(both, -viewer_, {0, 0.3 * cosine, 0}, -sun_direction);
    expect_response(both, -viewer_, {0, 0.3 * cosine, 0});
}

TEST_F(ProgrammedMaterial, BrtdfuncIsSeenFromBehindWhateverBvSays) {
    RenderSettings settings;
    settings.back_faces_visible = false;
    test::TracedScene scene(
        "void BRTDfunc m 10 1 1 1 0 0 0 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0" + test::plate + two_skies, settings);
    EXPECT_EQ(scene.radiance(viewer_ * -3.0, viewer_)[0], 10.0f);
}

// What rays are sent for is 0.3 mirrored, 0.1 straight on and 0.2 diffuse: the functions have no part in it.
TEST_F(ProgrammedMaterial, BrtdfuncEmitsWhatNoRayIsSentFor) {
    const double black = band_radiance(300, 8, 12);
    test::TracedScene scene(material("void BRTDfunc skin 10 .3 .3 .3 .1 .1 .1 white white white FILE 0 9 .15 "
                                     ".15 .15 0 0 0 .05 .05 .05\n"
                                     "void thermal m 1 skin 0 3 300 8 12") +
                                test::plate + test::surrounding(10),
                            test::bounce_settings(16));
    EXPECT_NEAR(scene.radiance(viewer_ * 3.0, -viewer_)[0], 0.4 * black + 0.6 * 10, 1e-4);
}

// Of more than three channels CrP is the mean of the red ones, and a value goes to all of them.
TEST_F(ProgrammedMaterial, ColorsOfSpectralChannels) {
    const auto channels = Channels::spectral(12, 380, 780);
    const std::vector<double> seen = response(
        "void spectrum s 0 0 6 780 380 .1 .2 .3 .4\n"
        "s BRTDfunc m 10 0 0 0 0 0 0 red green blue FILE 0 9 0 0 0 0 0 0 0 0 0",
        viewer_, sun_direction, channels);
    ASSERT_EQ(seen.size(), 12u);
    for (std::size_t c = 1; c < 12; ++c) {
        const bool same = channels.primary_of(int(c)) == channels.primary_of(int(c) - 1);
        if (same)
            EXPECT_EQ(seen[c], seen[c - 1]) << c;
        else
            EXPECT_GT(seen[c], seen[c - 1] * 1.1) << c;
    }
    EXPECT_GT(seen[0], 0.1 * sun_direction.z);
    EXPECT_LT(seen[11], 0.4 * sun_direction.z);
}

}  // namespace
}  // namespace infra
