// An instance is the same as its octree's surfaces written out where it places them.
#include <gtest/gtest.h>

#include "common/test_files.h"
#include "scene/transform.h"
#include "scene_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

const std::string gray = "void plastic gray 0 0 5 .5 .5 .5 0 0\n";

Transform transform_of(const std::string& options) {
    std::vector<std::string> list;
    std::istringstream in(options);
    for (std::string word; in >> word;) list.push_back(word);
    Transform transform;
    EXPECT_EQ(parse_transform(std::span<const std::string>(list), transform), list.size());
    return transform;
}

// "mod instance id N path options 0 0"
std::string instance(const std::string& modifier, const std::string& id, const std::string& path,
                     const std::string& options = "") {
    std::istringstream in(options);
    int count = 1;
    for (std::string word; in >> word;) ++count;
    return words(modifier, "instance", id, count, path, options, "0 0\n");
}

// Some shapes of a material, moved as xform moves them.
std::string shapes(const std::string& modifier, const Transform& t) {
    const auto at = [&](double x, double y, double z) {
        const Vec3 p = t.point({x, y, z});
        return words(p.x, p.y, p.z);
    };
    const auto along = [&](double x, double y, double z) {
        const Vec3 v = t.vector({x, y, z});
        return words(v.x, v.y, v.z);
    };
    const double s = t.magnification();
    // Corners are listed backwards where the transform mirrors, and a ring's normal is turned, so that fronts
    // stay fronts.
    const auto polygon = [&](std::string name, std::vector<std::string> corners) {
        if (t.mirrors()) std::reverse(corners.begin(), corners.end());
        std::string text = modifier + " polygon " + name + " 0 0 " + std::to_string(3 * corners.size()) + " ";
        for (const std::string& corner : corners) text += corner;
        return text + "\n";
    };
    return words(modifier, "sphere ball 0 0 4", at(0, 0, 0), s * 0.4, "\n") +
           words(modifier, "ring disk 0 0 8", at(-1, 0.5, 0), along(0.1, 0.2, 1), s * 0.1, s * 0.7, "\n") +
           words(modifier, "cone hat 0 0 8", at(0, 1, 0), at(0, 1.5, 0.8), s * 0.4, s * 0.1, "\n") +
           polygon("square", {at(1, 0, 0), at(2, 0, 0.1), at(2, 1, 0.1), at(1, 1, 0)}) +
           polygon("triangle", {at(0.5, -1, 0.5), at(1.5, -1, 0), at(1, -0.4, -0.6)});
}

class InstanceTest : public testing::Test {
  protected:
    test::TemporaryFolder folder_;

    std::string octree(const std::string& name, const std::string& rad) {
        test::write_octree_file(folder_ / name, rad);
        return folder_ / name;
    }

    static Interaction cast(test::TracedScene& scene, const Ray& ray) {
        Interaction at(ray);
        scene.tracer().cast(at);
        return at;
    }

    // Random rays through both scenes meet the same, up to the 31 bits of numbers in frozen octrees; returns
    // how many met something.
    static int expect_same_hits(const std::string& placed, const std::string& written, double tolerance) {
        test::TracedScene a(placed), b(written);
        RandomStream random(1, 2);
        const auto uniform = [&] { return 2 * random.uniform() - 1; };
        int hits = 0;
        for (int n = 0; n < 4000; ++n) {
            const Vec3 from = normalize(Vec3{uniform(), uniform(), uniform()}) * 20.0;
            const Vec3 to = Vec3{uniform(), uniform(), uniform()} * 3.0;
            const Ray ray = a.tracer().primary(from, normalize(to - from), 0);
            const Interaction x = cast(a, ray), y = cast(b, ray);
            EXPECT_EQ(x.hit(), y.hit());
            if (!x.hit() || !y.hit()) continue;
            ++hits;
            EXPECT_EQ(a.compiled().surface_name(x.surface), b.compiled().surface_name(y.surface));
            EXPECT_EQ(a.compiled().modifier_name(x.surface), b.compiled().modifier_name(y.surface));
            EXPECT_NEAR(x.distance, y.distance, tolerance);
            EXPECT_NEAR(length(x.normal - y.normal), 0, tolerance);
            EXPECT_NEAR(x.cosine, y.cosine, tolerance);
            using View = Geometry::View;
            const Geometry& geometry = a.compiled().geometry();
            EXPECT_EQ(geometry.view(ray.origin, ray.direction, x.distance - 1e-4, {}), View::clear);
            EXPECT_EQ(geometry.view(ray.origin, ray.direction, x.distance + 1e-4, {}), View::blocked);
        }
        return hits;
    }
};

TEST_F(InstanceTest, MeetsWhatIsWrittenOut) {
    const std::string part = octree("part.oct", gray + shapes("gray", {}));
    for (const char* const options : {"", "-t 0 0 1", "-rx 20 -s 1.5 -t 1 0 2", "-mx -rz 30", "-s .7"}) {
        const std::string written = gray + shapes("gray", transform_of(options));
        const int hits = expect_same_hits(instance("void", "i", part, options), written, 1e-6);
        EXPECT_GT(hits, 100) << options;
    }
}

TEST_F(InstanceTest, ThreeDeepWithScaleAndMirror) {
    const std::string part = octree("part.oct", gray + shapes("gray", {}));
    const std::string inner = octree("inner.oct", instance("void", "a", part, "-s 2 -t 1 0 0") +
                                                      instance("void", "b", part, "-mz -t -2 1 0"));
    const std::string outer = octree("outer.oct", instance("void", "c", inner, "-rx 30 -mx -s .5") +
                                                      instance("void", "d", inner, "-t 0 2 1") + gray +
                                                      "gray sphere extra 0 0 4 0 0 -2 .5\n");
    std::string written = gray;
    const Transform a = transform_of("-s 2 -t 1 0 0"), b = transform_of("-mz -t -2 1 0");
    const Transform c = transform_of("-rx 30 -mx -s .5"), d = transform_of("-t 0 2 1");
    const Transform top = transform_of("-ry 40 -s .8");
    for (const Transform& first : {a, b})
        for (const Transform& second : {c, d}) written += shapes("gray", first * second * top);
    const Vec3 center = top.point({0, 0, -2});
    written += words("gray sphere extra 0 0 4", center.x, center.y, center.z, 0.4, "\n");
    EXPECT_GT(expect_same_hits(instance("void", "e", outer, "-ry 40 -s .8"), written, 1e-6), 500);
}

TEST_F(InstanceTest, LooksTheSameToTheLastBitWhereNothingIsRounded) {
    const std::string lamp =
        "void light lamp 0 0 3 30 30 30\nlamp sphere bulb 0 0 4 3 3 8 .5\n" + test::surrounding(0.5);
    const std::string part =
        octree("part.oct", gray + "gray polygon floor 0 0 12 -4 -4 -1 4 -4 -1 4 4 -1 -4 4 -1\n" +
                               "gray sphere ball 0 0 4 0 0 0 .5\n");
    RenderSettings settings;
    settings.ambient_bounces = 2;
    settings.ambient_divisions = 16;
    test::TracedScene placed(instance("void", "i", part, "-t 1 2 0") + lamp, settings);
    test::TracedScene written(gray + "gray polygon floor 0 0 12 -3 -2 -1 5 -2 -1 5 6 -1 -3 6 -1\n" +
                                  "gray sphere ball 0 0 4 1 2 0 .5\n" + lamp,
                              settings);
    for (int n = 0; n < 16; ++n) {
        const Vec3 from{1, 2, 4}, to{0.25 * n - 1, 0.5 * (n % 4) + 1, -1};
        EXPECT_EQ(placed.radiance(from, normalize(to - from))[0],
                  written.radiance(from, normalize(to - from))[0]);
    }
    EXPECT_EQ(placed.irradiance({2, 3, -1}, {0, 0, 1}), written.irradiance({2, 3, -1}, {0, 0, 1}));
}

// Value of a glow whose brightness is a function, along a ray.
double glow(const std::string& scene, const Vec3& from, const Vec3& along) {
    return static_cast<double>(test::TracedScene(scene).radiance(from, along)[0]);
}

TEST_F(InstanceTest, FunctionsSeeTheOctreesCoordinates) {
    const std::string square = "polygon p 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n";
    const auto part = [&](const std::string& expression, const std::string& transform = "") {
        const std::string strings = transform.empty() ? "2 " : "6 ";
        return octree("f.oct", "void brightfunc f " + strings + expression + " . " + transform +
                                   " 0 0\nf glow g 0 0 4 1 1 1 0\ng " + square);
    };
    const std::string placing = "-mx -s 2 -rz 90 -t 5 1 3";
    const Transform out = transform_of(placing);
    const Vec3 point = out.point({0.3, 0.6, 0});
    const auto seen = [&](const std::string& expression, const std::string& transform = "") {
        return glow(instance("void", "i", part(expression, transform), placing), point + Vec3{0, 0, 4},
                    {0, 0, -1});
    };
    EXPECT_NEAR(seen("Px"), 0.3, 1e-6);
    EXPECT_NEAR(seen("Py"), 0.6, 1e-6);
    EXPECT_NEAR(seen("Px", "-t -1 0 0"), 1.3, 1e-6);
    EXPECT_NEAR(seen("-Dz"), 1, 1e-6);
    EXPECT_NEAR(seen("Nz"), 1, 1e-6);
    EXPECT_NEAR(seen("T"), 2, 1e-6) << "lengths are the octree's";
    EXPECT_NEAR(seen("S"), 0.5, 1e-6);
}

TEST_F(InstanceTest, FunctionsSeeAllPlacementsAroundThem) {
    const std::string part = octree("f.oct",
                                    "void brightfunc f 2 Px+10*Py . 0 0\nf glow g 0 0 4 1 1 1 0\n"
                                    "g polygon p 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n");
    const std::string mid = octree("mid.oct", instance("void", "a", part, "-s 3 -t 1 0 0"));
    const Vec3 point = transform_of("-s 3 -t 1 0 0 -rx 180 -my -t 0 0 -2").point({0.2, 0.7, 0});
    EXPECT_NEAR(glow(instance("void", "b", mid, "-rx 180 -my -t 0 0 -2"), point + Vec3{0, 0, -3}, {0, 0, 1}),
                7.2, 1e-5);
}

TEST_F(InstanceTest, TexturesTurnWithTheInstance) {
    const std::string part =
        octree("t.oct",
               "void texfunc bump 4 .3 .1*Px 0 . 0 0\nbump plastic m 0 0 5 .5 .5 .5 0 0\n"
               "m polygon p 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n");
    const std::string placing = "-rz 90 -s 2";
    test::TracedScene scene(instance("void", "i", part, placing));
    const Vec3 point = transform_of(placing).point({0.5, 0.5, 0});
    const Ray ray = scene.tracer().primary(point + Vec3{0, 0, 3}, {0, 0, -1}, 0);
    Interaction at(ray);
    scene.tracer().trace(at);
    const Vec3 expected = normalize(Vec3{-0.05, 0.3, 1});
    EXPECT_NEAR(length(at.perturbed_normal() - expected), 0, 1e-9);
}

TEST_F(InstanceTest, AModifierOfItsOwnHidesThoseInside) {
    const std::string part = octree("part.oct", gray + "gray sphere ball 0 0 4 0 0 0 1\n");
    const std::string mid = octree("mid.oct", instance("void", "a", part, "-t 0 0 0"));
    const std::string outside = "void brightfunc f 2 Pz . 0 0\nf glow own 0 0 4 1 1 1 0\n";
    const std::string scene_text = outside + instance("own", "shown", mid, "-t 0 0 5");
    test::TracedScene scene(scene_text);
    const HitState hit = scene.nearest({0, 0, 9}, {0, 0, -1});
    EXPECT_EQ(scene.compiled().surface_name(hit.surface), "shown");
    EXPECT_EQ(scene.compiled().modifier_name(hit.surface), "own");
    EXPECT_NEAR(glow(scene_text, {0, 0, 9}, {0, 0, -1}), 6, 1e-6) << "in the coordinates of the scene";
}

TEST_F(InstanceTest, AmbientListsNameModifiersInside) {
    const std::string part = octree("part.oct", gray + "gray polygon p 0 0 9 -1 -1 0 1 -1 0 0 1 0\n");
    RenderSettings settings = test::bounce_settings(16);
    settings.ambient_filter = {NameFilter::Mode::exclude, {"gray"}};
    test::TracedScene scene(instance("void", "i", part) + test::surrounding(2), settings);
    EXPECT_EQ(scene.radiance({0, 0, 3}, {0, 0, -1})[0], 0);
}

TEST_F(InstanceTest, FlatSurfacesDoNotMeetThemselvesButTheirCopies) {
    // Two copies of a square face each other; a ray that leaves one must meet the other.
    const std::string part = octree("part.oct", gray + "gray polygon p 0 0 12 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n");
    test::TracedScene scene(instance("void", "low", part) +
                            instance("void", "high", part, "-rx 180 -t 0 0 1"));
    const Ray down = scene.tracer().primary({0, 0, 0.5}, {0, 0, -1}, 0);
    Interaction low(down);
    scene.tracer().cast(low);
    HitState state;
    scene.compiled().geometry().intersect(low.point - Vec3{0, 0, 1e-3}, {0, 0, 1},
                                          {low.flat_shape, low.placement}, state);
    EXPECT_NEAR(state.distance, 1.001, 1e-9);
    EXPECT_NE(low.placement, 0u);
}

TEST_F(InstanceTest, OverlappingInstancesFollowTheRuleOfCoincidence) {
    const std::string opaque =
        octree("a.oct", "void plastic early 0 0 5 .5 .5 .5 0 0\nearly ring r 0 0 8 0 0 0 0 0 1 0 2\n");
    const std::string clear =
        octree("b.oct", "void glass pane 0 0 3 1 1 1\npane ring r 0 0 8 0 0 0 0 0 1 0 2\n");
    for (const std::string& text : {instance("void", "i", opaque) + instance("void", "j", clear),
                                    instance("void", "j", clear) + instance("void", "i", opaque)}) {
        test::TracedScene scene(text);
        const HitState hit = scene.nearest({0.1, 0.2, 3}, {0, 0, -1});
        EXPECT_EQ(scene.compiled().modifier_name(hit.surface), "early");
    }
}

TEST_F(InstanceTest, LightsInsideAreSeenButGiveNone) {
    const std::string part = octree(
        "lamp.oct", "void light l 0 0 3 9 9 9\nl sphere s 0 0 4 0 0 3 .5\nl source sun 0 0 4 0 0 1 5\n");
    test::TracedScene scene(instance("void", "i", part) + gray + "gray ring floor 0 0 8 0 0 0 0 0 1 0 5\n");
    EXPECT_EQ(scene.radiance({0, 3, 3}, {0, -1, 0})[0], 9);
    EXPECT_EQ(scene.radiance({0, 3, 3}, normalize(Vec3{0, -1, -3}))[0], 0);
    EXPECT_EQ(scene.radiance({0, 9, 3}, {0, 0, 1})[0], 0);
    std::string warnings;
    for (const std::string& warning : scene.compiled().warnings()) warnings += warning + "\n";
    EXPECT_NE(warnings.find("light sources within an instance"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("distant sources within an instance"), std::string::npos) << warnings;
}

TEST_F(InstanceTest, WhatIsRefused) {
    const auto refusal = [](const std::string& text) {
        return test::error_of([&] { test::TracedScene scene(text); });
    };
    const std::string self = folder_ / "self.oct";
    test::write_octree_file(self, instance("void", "again", self));
    EXPECT_NE(refusal(instance("void", "i", self)).find("contains an instance of itself"), std::string::npos);
    EXPECT_NE(refusal(instance("void", "i", folder_ / "none.oct")).find("cannot find octree file"),
              std::string::npos);
    test::write_file(folder_ / "text.oct", gray);
    const std::string wrong = refusal(instance("void", "i", folder_ / "text.oct"));
    EXPECT_TRUE(wrong.starts_with("test.rad:1: instance \"i\"")) << wrong;
    EXPECT_NE(wrong.find("made by oconv"), std::string::npos) << wrong;
    const std::string part = octree("part.oct", gray + "gray sphere s 0 0 4 0 0 0 1\n");
    EXPECT_NE(refusal(words("void instance i 3", part, "-t 1 0 0")).find("bad transform"), std::string::npos);
    EXPECT_NE(refusal(words("void mesh i 1", part, "0 0")).find("made by obj2mesh"), std::string::npos);
}

}  // namespace
}  // namespace infra
