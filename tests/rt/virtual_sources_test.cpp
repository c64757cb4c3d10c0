// Light sources seen in mirrors and prisms, against closed forms: images give light like sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.01, reflectance = 0.8;
const Vec3 up{0, 0, 1};
const std::string silver = "void mirror silver 0 0 3 .8 .8 .8\n";
const std::string lamp = "void light lamp 0 0 3 1e4 1e4 1e4\n";

std::string bulb(const Vec3& at) { return words("lamp sphere bulb 0 0 4", at.x, at.y, at.z, radius, "\n"); }

/// A mirror in the plane x = at, far beyond everything, that faces towards +x or -x.
std::string wall_x(double at, int facing) {
    return words("silver polygon wall 0 0 12", at, -99 * facing, -99, at, 99 * facing, -99, at, 99 * facing,
                 99, at, -99 * facing, 99, "\n");
}

/// Irradiance that a bulb gives on a horizontal surface at the point.
double from_bulb(const Vec3& bulb, const Vec3& point) {
    const Vec3 offset = bulb - point;
    const double distance = length(offset);
    return 1e4 * pi * radius * radius * offset.z / (distance * distance * distance);
}

RenderSettings relays(int count, int pretest = 0) {
    RenderSettings settings;
    settings.direct_relays = count;
    settings.direct_pretest = pretest;
    settings.shadow_threshold = 0;
    return settings;
}

void expect_irradiance(const std::string& rad, const RenderSettings& settings, const Vec3& point,
                       double expected, double tolerance = 1e-4) {
    test::TracedScene scene(rad, settings);
    EXPECT_NEAR(scene.irradiance(point, up), expected, tolerance * expected + 1e-12) << rad;
}

TEST(VirtualSources, BulbBeforeAMirrorIsTwoBulbs) {
    const Vec3 at{1, 0.3, 2}, image{-1, 0.3, 2}, point{2, -0.5, 0};
    const std::string rad = lamp + silver + bulb(at) + wall_x(0, 1);
    const double direct = from_bulb(at, point), mirrored = reflectance * from_bulb(image, point);
    expect_irradiance(rad, relays(0), point, direct);
    for (const int pretest : {0, 64}) expect_irradiance(rad, relays(1, pretest), point, direct + mirrored);
    expect_irradiance(lamp + silver + bulb(at) + wall_x(0, -1), relays(1), point, direct);  // its black back
}

TEST(VirtualSources, CornerOfTwoMirrorsShowsThreeImages) {
    const std::string corner =
        wall_x(0, 1) + "silver polygon other 0 0 12 99 0 -99 -99 0 -99 -99 0 99 99 0 99\n";
    const Vec3 at{1, 0.6, 2}, point{1.5, 2, 0};
    const double direct = from_bulb(at, point);
    const double once = reflectance * (from_bulb({-1, 0.6, 2}, point) + from_bulb({1, -0.6, 2}, point));
    const double twice = reflectance * reflectance * from_bulb({-1, -0.6, 2}, point);
    const std::string rad = lamp + silver + bulb(at) + corner;
    for (const int pretest : {0, 16}) {
        expect_irradiance(rad, relays(1, pretest), point, direct + once);
        expect_irradiance(rad, relays(2, pretest), point, direct + once + twice);
        expect_irradiance(rad, relays(5, pretest), point, direct + once + twice);
    }
}

TEST(VirtualSources, ParallelMirrorsMakeARowOfImages) {
    const double x0 = 0.3;
    const Vec3 point{-0.2, 0.4, 0};
    const std::string rad = lamp + silver + bulb({x0, 0, 1.5}) + wall_x(-1, 1) + wall_x(1, -1);
    for (const int most : {1, 4, 9}) {
        double expected = 0;
        for (int n = -most; n <= most; ++n)
            expected +=
                std::pow(reflectance, std::abs(n)) * from_bulb({2.0 * n + (n % 2 ? -x0 : x0), 0, 1.5}, point);
        expect_irradiance(rad, relays(most), point, expected);
    }
}

TEST(VirtualSources, SunByAMirror) {
    const Vec3 to_sun = normalize(Vec3{0.5, 0.1, 0.8});
    const std::string sun = words("void light glare 0 0 3 1e4 1e4 1e4 glare source sun 0 0 4", to_sun.x,
                                  to_sun.y, to_sun.z, ".5\n");
    const double expected = 1e4 * 2 * pi * (1 - std::cos(0.25 * test::degree)) * to_sun.z;
    for (const int pretest : {0, 512})
        expect_irradiance(sun + silver + wall_x(0, 1), relays(1, pretest), {2, 0, 0},
                          (1 + reflectance) * expected, 1e-3);
    // beside the beam that a small mirror throws: only the sun itself
    const std::string pane = "silver polygon pane 0 0 12 0 -.1 1 0 .1 1 0 .1 1.2 0 -.1 1.2\n";
    const double x = 1.1 * to_sun.x / to_sun.z, y = -1.1 * to_sun.y / to_sun.z;
    expect_irradiance(sun + silver + pane, relays(1), {x, y, 0}, (1 + reflectance) * expected, 1e-3);
    expect_irradiance(sun + silver + pane, relays(1), {x + 0.3, y, 0}, expected, 1e-3);
}

TEST(VirtualSources, MirroredSpotlightKeepsItsBeam) {
    const std::string rad = silver + wall_x(0, 1) +
                            "void spotlight beam 0 0 7 1e4 1e4 1e4 20 -1 0 -1\n"
                            "beam sphere bulb 0 0 4 1 0 2 .01\n";
    const Vec3 image{-1, 0, 2};  // shines towards +x and down, from sqrt(2) behind itself
    const Vec3 inside{1, 0, 0}, outside{2, 0, 0};
    const double distance = std::sqrt(8.0), from_focus = distance + std::sqrt(2.0);
    const double expected =
        reflectance * from_bulb(image, inside) * distance * distance / (from_focus * from_focus);
    expect_irradiance(rad, relays(1), inside, expected, 1e-3);
    expect_irradiance(rad, relays(1), outside, 0);
}

TEST(VirtualSources, LightPassesGlassOnItsWayToTheMirror) {
    const Vec3 at{1, 0, 1}, point{1, 0, 0};
    const auto mirrored_part = [&](const std::string& pane) {
        const std::string rad = lamp + silver + bulb(at) + wall_x(0, 1) + pane;
        test::TracedScene scene(rad, relays(1, 16));
        return scene.irradiance(point, up) - from_bulb(at, point);
    };
    const double free = mirrored_part("");
    const std::string pane =
        "void glass clear 0 0 4 1 1 1 1.5 clear polygon pane 0 0 12 .5 -9 .5 .5 9 .5 "
        ".5 9 2 .5 -9 2\n";
    const double behind = mirrored_part(pane);
    EXPECT_NEAR(free, reflectance * from_bulb({-1, 0, 1}, point), 1e-3 * free);
    EXPECT_GT(behind, 0.85 * free);  // of two faces at 27 degrees 0.92 is left
    EXPECT_LT(behind, 0.95 * free);
    EXPECT_NEAR(mirrored_part("void plastic lid 0 0 5 .5 .5 .5 0 0 lid polygon l 0 0 12 .5 -9 .5 .5 9 .5 "
                              ".5 9 2 .5 -9 2\n"),
                0, 1e-3 * free);
}

TEST(VirtualSources, PretestLeavesOutWhatIsHidden) {
    const std::string room = lamp + silver + bulb({1, 0, 1}) + wall_x(0, 1);
    const std::string lid =
        "void plastic grey 0 0 5 .5 .5 .5 0 0 grey polygon lid 0 0 12 .5 -999 -999 .5 999 -999 .5 999 999 "
        ".5 -999 999\n";
    const auto images = [](const std::string& rad, int pretest) {
        return test::TracedScene(rad, relays(1, pretest)).compiled().sources().size() - 1;
    };
    EXPECT_EQ(images(room, 0), 1u);
    EXPECT_EQ(images(room, 16), 1u);
    EXPECT_EQ(images(room + lid, 0), 1u);
    EXPECT_EQ(images(room + lid, 16), 0u);
}

TEST(VirtualSources, AreOnlyMadeWhereLightCanGo) {
    // A ring of mirrors that face outward, and lamps around them: no mirror sees another.
    std::string rad = lamp + silver;
    constexpr int count = 24;
    for (int i = 0; i < count; ++i) {
        const double a = 2 * pi * i / count;
        rad += words("silver ring m 0 0 8", 5 * std::cos(a), 5 * std::sin(a), 0, std::cos(a), std::sin(a), 0,
                     0, .3);
        rad += bulb({9 * std::cos(a), 9 * std::sin(a), 0});
    }
    const test::TracedScene scene(rad, relays(4));
    const auto& sources = scene.compiled().sources();
    EXPECT_LE(sources.size(), static_cast<std::size_t>(count + count * count));
    for (std::size_t i = count; i < sources.size(); ++i) EXPECT_LT(sources[i].parent, count);
}

TEST(VirtualSources, GlowsBeyondTheirReachAndGlowingSkiesHaveNone) {
    const std::string near = "void glow near 0 0 4 1e4 1e4 1e4 1.5 near sphere bulb 0 0 4 2 0 1 .01\n";
    const test::TracedScene scene(
        near + silver + "silver ring m 0 0 8 0 0 1 1 0 0 0 .2\n" + test::surrounding(1), relays(2));
    EXPECT_EQ(scene.compiled().sources().size(), 2u);
}

TEST(VirtualSources, AlternateMaterialIsSeenAndTheMirrorLights) {
    const Vec3 at{1, 0.3, 2}, point{2, -0.5, 0};
    const double expected = from_bulb(at, point) + reflectance * from_bulb({-1, 0.3, 2}, point);
    const std::string backdrop = "void light red 0 0 3 3 0 0 red source back 0 0 4 -1 0 0 20\n";
    for (const std::string other : {"panel", "void"}) {
        const std::string material =
            "void light panel 0 0 3 0 7 0\nvoid mirror silver 1 " + other + " 0 3 .8 .8 .8\n";
        const std::string rad = lamp + material + bulb(at) + wall_x(0, 1);
        expect_irradiance(rad, relays(1), point, expected);
        test::TracedScene scene(rad + backdrop, relays(0));
        const Spectrum seen = scene.radiance({3, 0, 1}, {-1, 0, 0});
        EXPECT_EQ(seen[0], other == "void" ? 3.0f : 0.0f);
        EXPECT_EQ(seen[1], other == "void" ? 0.0f : 7.0f);
    }
}

TEST(VirtualSources, MirrorsWithATemperatureOrAGlowShowThemToo) {
    const Vec3 at{1, 0.3, 2}, point{2, -0.5, 0};
    const double expected = from_bulb(at, point) + reflectance * from_bulb({-1, 0.3, 2}, point);
    for (const char* skin :
         {"void thermal skin 1 silver 0 3 300 8 12\n", "void emissive skin 1 silver 0 3 1 1 1\n",
          "void illum skin 1 silver 0 3 0 0 0\n"}) {
        std::string wall = wall_x(0, 1);
        wall.replace(0, 6, "skin");
        expect_irradiance(lamp + silver + skin + bulb(at) + wall, relays(1), point, expected);
    }
}

TEST(VirtualSources, CurvedMirrorsHaveNoneAndSaySo) {
    const test::TracedScene scene(lamp + silver + bulb({2, 0, 0}) +
                                      "silver sphere ball 0 0 4 0 0 0 1\nsilver sphere more 0 0 4 0 5 0 1\n",
                                  relays(2));
    EXPECT_EQ(scene.compiled().sources().size(), 1u);
    const auto& warnings = scene.compiled().warnings();
    EXPECT_EQ(
        std::count_if(warnings.begin(), warnings.end(),
                      [](const std::string& w) { return w.find("light sources are not seen") != w.npos; }),
        1);
}

/// A prism overhead, wide, for a sun in the zenith; `strings` are its functions.
std::string under_prism(const std::string& type, int count, const std::string& strings) {
    return "void light glare 0 0 3 1e4 1e4 1e4 glare source sun 0 0 4 0 0 1 .5\nvoid " + type + " film " +
           std::to_string(count) + " " + strings +
           " . 0 0\nfilm polygon pane 0 0 12 -99 -99 3 99 -99 3 99 99 3 -99 99 3\n";
}

/// Turns light by an angle about the x axis, and what comes the other way back.
std::string turned(double angle) {
    const std::string c = std::to_string(std::cos(angle));
    const std::string s = "if(Dz,-1,1)*" + std::to_string(std::sin(angle));
    return "Dx " + c + "*Dy-" + s + "*Dz " + s + "*Dy+" + c + "*Dz";
}

const double zenith_sun = 1e4 * 2 * pi * (1 - std::cos(0.25 * test::degree));

TEST(VirtualSources, PrismThatTurnsNothingPassesItsShare) {
    expect_irradiance(under_prism("prism1", 5, ".6 Dx Dy Dz"), relays(1), {0, 0, 0}, 0.6 * zenith_sun, 1e-3);
    expect_irradiance(under_prism("prism1", 5, ".6 Dx Dy Dz"), relays(0), {0, 0, 0}, 0);
}

TEST(VirtualSources, PrismTurnsTheSun) {
    for (const double angle : {0.2, -0.7})
        for (const int pretest : {0, 64})
            expect_irradiance(under_prism("prism1", 5, ".6 " + turned(angle)), relays(1, pretest), {0, 0, 0},
                              0.6 * zenith_sun * std::cos(angle), 2e-3);
    expect_irradiance(under_prism("prism2", 9, ".5 " + turned(0.4) + " .3 " + turned(-0.3)), relays(1),
                      {0, 0, 0}, zenith_sun * (0.5 * std::cos(0.4) + 0.3 * std::cos(0.3)), 2e-3);
}

TEST(VirtualSources, PrismKnowsWhereItsLightIs) {
    // only rays that go to a source know of one: the functions turn them straight there
    expect_irradiance(under_prism("prism1", 5, ".6 if(DzA,DxA,Dx) if(DzA,DyA,Dy+.2*Dz) if(DzA,DzA,Dz)"),
                      relays(1), {0, 0, 0}, 0.6 * zenith_sun / std::sqrt(1.04), 2e-3);
}

TEST(VirtualSources, PrismShowsWhatItTurnsTo) {
    test::TracedScene scene(
        under_prism("prism2", 9, ".5 0 0 1 .25 0 0 -1") +
            "void light floor 0 0 3 8 8 8 floor polygon f 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n",
        relays(0));
    EXPECT_EQ(scene.radiance({0, 0, 1}, normalize(Vec3{0.3, 0, 1}))[0], 0.5f * 1e4f + 0.25f * 8.0f);
}

std::string message_of(const std::string& rad) {
    try {
        test::TracedScene scene(rad, relays(1));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(VirtualSources, BadMirrorsAndPrismsAreRefused) {
    const std::string ball = " sphere b 0 0 4 0 0 0 1\n";
    EXPECT_NE(message_of("void brightfunc half 2 .5 . 0 0 void mirror m 1 half 0 3 1 1 1 m" + ball)
                  .find("\"half\" is not a material"),
              std::string::npos);
    EXPECT_NE(message_of("void mirror m 1 nothing 0 3 1 1 1 m" + ball).find("undefined modifier \"nothing\""),
              std::string::npos);
    EXPECT_NE(message_of("void mirror m 0 0 2 1 1 m" + ball), "");
    EXPECT_NE(message_of("void prism1 m 4 1 Dx Dy Dz 0 0 m" + ball), "");
    EXPECT_NE(message_of("void prism2 m 9 1 Dx Dy Dz 1 Dx Dy Dz none.cal 0 0 m" + ball).find("none.cal"),
              std::string::npos);
}

}  // namespace
}  // namespace infra
