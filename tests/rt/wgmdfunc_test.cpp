// WGMDfunc: each part against the material it imitates, modifiers of its own, both sides, emission.
#include <gtest/gtest.h>

#include <numbers>

#include "common/planck/planck.h"
#include "common/test_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;

constexpr double pi = std::numbers::pi;
const Vec3 viewer = test::direction(40 * degree, 0.9 + pi);
const std::string sun =
    "\nvoid light sunlight 0 0 3 5000 4000 3000 sunlight source sun 0 0 4 .45 .56 .8 4\n"
    "sunlight source other 0 0 4 -.2 .1 -1 4\n";
const std::string no_rest = " 0 9 0 0 0 0 0 0 0 0 0";

Spectrum seen(const std::string& text, const Vec3& to_viewer = viewer, const RenderSettings& settings = {}) {
    return test::TracedScene(text + test::plate + sun, settings).radiance(to_viewer * 3.0, -to_viewer);
}

void expect_same(const std::string& text, const std::string& other) {
    for (const Vec3& to_viewer : {viewer, -viewer, test::direction(1.3, 2), test::direction(1.9, 5)}) {
        const Spectrum a = seen(text, to_viewer), b = seen(other, to_viewer);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(a[c], b[c], 2e-6f * b[c]) << text << "\nand " << other << "\nchannel " << c;
    }
}

TEST(Wgmdfunc, ImitatesTheMaterialsOfFixedParts) {
    expect_same("void WGMDfunc m 13 void .1 .1 .3 void 0 0 0 void 1 .5 0 . 0 9 .45 .36 .27 .45 .36 .27 0 0 0",
                "void plastic2 m 4 1 .5 0 . 0 6 .5 .4 .3 .1 .1 .3");
    expect_same("void WGMDfunc m 13 void .1 .2 .2 void 0 0 0 void 0 0 1 . 0 9 .45 .36 .27 .45 .36 .27 0 0 0",
                "void plastic m 0 0 5 .5 .4 .3 .1 .2");
    // 0.9 are not reflected; 0.6 of them go through, 0.4 of those not diffused
    expect_same(
        "void WGMDfunc m 15 void .1 .1 .3 void .216 .1 .3 void 1 .5 0 . -rz 20\n"
        "0 9 .36 .36 .36 .36 .36 .36 .324 .324 .324",
        "void trans2 m 6 1 .5 0 . -rz 20 0 8 1 1 1 .1 .1 .3 .6 .4");
}

// A vector along the normal gives no direction: the slopes' root mean square counts.
TEST(Wgmdfunc, WithoutADirectionIsRoughAllAround) {
    expect_same("void WGMDfunc m 13 void .1 .1 .7 void 0 0 0 void 0 0 1 ." + no_rest,
                "void WGMDfunc m 13 void .1 .5 .5 void 0 0 0 void 1 0 0 ." + no_rest);
}

TEST(Wgmdfunc, PartsHaveModifiersOfTheirOwn) {
    const std::string patterns =
        "void colorfunc tint 4 .5 .6 .7 . 0 0 void brightfunc dim 2 .25 . 0 0\n"
        "void texfunc bend 4 .2 .1 0 . 0 0 bend brightfunc bent 2 .8 . 0 0 ";
    const auto part = [&](const std::string& modifier, const std::string& strings, const std::string& reals) {
        return patterns + modifier + " WGMDfunc m 13 " + strings + " 1 0 0 . 0 9 " + reals;
    };
    const std::string none = "0 0 0 0 0 0 0 0 0", front_only = ".3 .3 .3 .2 .2 .2 0 0 0",
                      through_only = "0 0 0 0 0 0 .1 .1 .1";
    // the main modifier is that of the diffuse reflection...
    expect_same(part("tint", "void 0 0 0 void 0 0 0 void", front_only),
                part("void", "void 0 0 0 void 0 0 0 void", ".15 .18 .21 .1 .12 .14 0 0 0"));
    // ... and of the other parts where they say so
    expect_same(part("tint", "inherit .1 .2 .1 inherit .4 .2 .2 inherit", through_only),
                part("void", "tint .1 .2 .1 tint .4 .2 .2 tint", through_only));
    expect_same(part("tint", "dim .4 .2 .1 void 0 0 0 void", none),
                part("void", "void .1 .2 .1 void 0 0 0 void", none));
    expect_same(part("tint", "void 0 0 0 dim .8 .1 .2 void", none),
                part("void", "void 0 0 0 void .2 .1 .2 void", none));
    expect_same(part("dim", "void 0 0 0 void 0 0 0 tint", through_only),
                part("void", "void 0 0 0 void 0 0 0 void", "0 0 0 0 0 0 .05 .06 .07"));
    // so do textures
    expect_same(part("void", "bent .1 .2 .1 void 0 0 0 void", none),
                part("bend", "inherit .08 .2 .1 void 0 0 0 void", none));
    expect_same(part("void", "void 0 0 0 void 0 0 0 bent", through_only),
                part("bend", "void 0 0 0 void 0 0 0 inherit", "0 0 0 0 0 0 .08 .08 .08"));
}

// A mirror takes from the diffuse part what it reflects, towards the viewer and from the light.
TEST(Wgmdfunc, SmoothPartsShowFresnelReflection) {
    const std::string sky = "void glow high 0 0 4 3 3 3 0 high source up 0 0 4 0 0 1 180\n";
    const auto fresnel = [](double c) { return std::exp(-5.85 * c) - 0.00202943064; };
    for (const double angle : {0.0, 40.0, 70.0, 85.0}) {
        const Vec3 to_viewer = test::direction(angle * degree, 0.4);
        test::TracedScene mirror("void WGMDfunc m 13 void .3 0 .2 void 0 0 0 void 0 0 1 ." + no_rest +
                                 test::plate + sky);
        const double f = fresnel(to_viewer.z);
        EXPECT_NEAR(mirror.radiance(to_viewer * 3.0, -to_viewer)[0], 3 * (0.3 + f * 0.7), 1e-5);
        const float bare = seen(
            "void WGMDfunc m 13 void 0 0 0 void 0 0 0 void 0 0 1 . 0 9 .2 0 0 0 0 0 0 0 0", to_viewer)[0];
        const float coated = seen(
            "void WGMDfunc m 13 void .3 0 0 void 0 0 0 void 0 0 1 . 0 9 .2 0 0 0 0 0 0 0 0", to_viewer)[0];
        const double light = fresnel(normalize(Vec3{.45, .56, .8}).z);
        EXPECT_NEAR(coated, bare * (1 - f) * (1 - light), 1e-5 * bare);
    }
}

TEST(Wgmdfunc, OnlyClearPartsLetShadowRaysThrough) {
    const auto lit = [](const std::string& transmission) {
        test::TracedScene scene("void WGMDfunc pane 13 void .1 .1 .1 " + transmission + " void 0 0 1 ." +
                                no_rest + "\npane ring roof 0 0 8 0 0 2 0 0 1 0 9\n" + sun);
        return scene.irradiance({0, 0, 0}, {0, 0, 1});
    };
    const double open = lit("void 1 0 0");
    EXPECT_GT(open, 1);
    EXPECT_EQ(lit("void 0 0 0"), 0);
    EXPECT_EQ(lit("void .5 .1 .1"), 0);
    EXPECT_NEAR(lit("void .5 0 0"), 0.5 * open, 1e-5 * open);
}

TEST(Wgmdfunc, ExpressionsTellFrontFromBack) {
    const std::string by_side =
        "void WGMDfunc m 13 void if(Rdot,.1,.2) .2 .2 void 0 0 0 void 0 0 1 ." + no_rest;
    const auto fixed = [](const std::string& share) {
        return "void WGMDfunc m 13 void " + share + " .2 .2 void 0 0 0 void 0 0 1 ." + no_rest;
    };
    EXPECT_EQ(seen(by_side, viewer), seen(fixed(".1"), viewer));
    EXPECT_EQ(seen(by_side, -viewer), seen(fixed(".2"), -viewer));
}

// With several rays the lobe of a single hit loses energy, which its emission makes up for.
TEST(Wgmdfunc, IsInvisibleInAFurnace) {
    RenderSettings settings = test::path_settings();
    settings.min_weight = 1e-6;
    const double black = band_radiance(300, 8, 12);
    for (const double samples : {1.0, 8.0})
        for (const double angle : {0.0, 50.0, 80.0}) {
            settings.specular_samples = samples;
            test::TracedScene scene(
                "void WGMDfunc skin 13 void .6 .1+.1*Px .3 void .2 .1 .1 void 0 1 0 . 0 9 .1 .1 .1 .1 .1 .1 "
                ".05 .05 .05\n"
                "void thermal m 1 skin 0 3 300 8 12\n"
                "void thermal wall 0 0 3 300 8 12 wall bubble room 0 0 4 0 0 0 9" +
                    test::plate,
                settings);
            test::expect_close(test::seen(scene, test::view_of_plate(angle * degree, 0.4), 20000), black,
                               2e-3);
        }
}

std::string refusal(const std::string& text) {
    return test::error_of([&] { test::TracedScene scene(text + test::plate); });
}

TEST(Wgmdfunc, Refusals) {
    const auto expect = [&](const std::string& text, const std::string& what) {
        const std::string message = refusal(text);
        EXPECT_TRUE(message.starts_with("test.rad:")) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    expect("void WGMDfunc m 13 no_such .1 .1 .1 void 0 0 0 void 0 0 1 ." + no_rest,
           "undefined modifier \"no_such\"");
    expect("void WGMDfunc m 13 void 0 0 0 no_such .1 0 0 void 0 0 1 ." + no_rest,
           "undefined modifier \"no_such\"");
    expect("void WGMDfunc m 13 void 0 0 0 void 0 0 0 no_such 0 0 1 . 0 9 0 0 0 0 0 0 .1 .1 .1",
           "undefined modifier \"no_such\"");
    expect("void plastic p 0 0 5 1 1 1 0 0\nvoid WGMDfunc m 13 p .1 .1 .1 void 0 0 0 void 0 0 1 ." + no_rest,
           "\"p\" is a material");
    expect("void plastic p 0 0 5 1 1 1 0 0\np WGMDfunc m 13 void .1 .1 .1 void 0 0 0 void 0 0 1 ." + no_rest,
           "conflicting material \"p\"");
    expect("void WGMDfunc m 12 void .1 .1 .1 void 0 0 0 void 0 0 1" + no_rest, "string arguments");
    expect("void WGMDfunc m 13 void .1+ .1 .1 void 0 0 0 void 0 0 1 ." + no_rest, "m");
    // What is not there needs no modifier
    EXPECT_EQ(refusal("void WGMDfunc m 13 no_such 0 .1 .1 no_such 0 0 0 no_such 0 0 1 ." + no_rest),
              "no error");
}

}  // namespace
}  // namespace infra
