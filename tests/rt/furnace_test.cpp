// VALIDATION V3, closed isothermal enclosures: whatever the walls are made of, radiance is that of a black
// body everywhere.
#include <gtest/gtest.h>

#include <numbers>

#include "rt/materials/scattering.h"
#include "test_tables.h"
#include "traced_scene.h"

namespace infra {
namespace {

constexpr double black_body = 38.50042;  // 300 K, 8-12 um
constexpr double bar = 1e-3;
constexpr int rays = 4000;

/// An emissive wall "wall" around a material "m" whose emissivity is the same in every direction.
std::string wall(const std::string& material, double emissivity) {
    const double le = emissivity * black_body;
    return material + test::words("\nvoid emissive wall 1 m 0 3", le, le, le, "\n");
}

const std::string sphere = "wall bubble enclosure 0 0 4 0 0 0 1\n";
const std::string box =
    "wall polygon x0 0 0 12 -1 -1 -1 -1 1 -1 -1 1 1 -1 -1 1\n"
    "wall polygon x1 0 0 12 1 -1 -1 1 -1 1 1 1 1 1 1 -1\n"
    "wall polygon y0 0 0 12 -1 -1 -1 -1 -1 1 1 -1 1 1 -1 -1\n"
    "wall polygon y1 0 0 12 -1 1 -1 1 1 -1 1 1 1 -1 1 1\n"
    "wall polygon z0 0 0 12 -1 -1 -1 1 -1 -1 1 1 -1 -1 1 -1\n"
    "wall polygon z1 0 0 12 -1 -1 1 -1 1 1 1 1 1 1 -1 1\n";

// Rays from anywhere within to anywhere.
test::Estimate seen_inside(test::TracedScene& scene, int count) {
    return scene.mean_radiance(count, [](RandomStream& random) {
        const auto symmetric = [&] { return 2 * random.uniform() - 1; };
        const Vec3 origin{0.5 * symmetric(), 0.5 * symmetric(), 0.5 * symmetric()};
        return test::RaySpec{
            origin, test::direction(std::acos(symmetric()), 2 * std::numbers::pi * random.uniform())};
    });
}

void expect_furnace(const std::string& scene_text, int count = rays) {
    SCOPED_TRACE(scene_text);
    RenderSettings settings = test::path_settings();
    settings.min_weight = 2e-3;
    test::TracedScene scene(scene_text, settings);
    test::expect_close(seen_inside(scene, count), black_body, bar);
    EXPECT_EQ(scene.tracer().bad_values(), 0u);
}

TEST(Furnace, DiffuseWallsOfAnyReflectance) {
    for (const double reflectance : {0.0, 0.1, 0.5, 0.9}) {
        const std::string text =
            wall(test::words("void plastic m 0 0 5", reflectance, reflectance, reflectance, "0 0"),
                 1 - reflectance);
        expect_furnace(text + sphere);
        expect_furnace(text + box);
    }
}

TEST(Furnace, RoughPlasticAndMetal) {
    for (const double roughness : {0.05, 0.3}) {
        const double plastic_albedo = 0.6 * 0.7 + 0.3;
        expect_furnace(wall(test::words("void plastic m 0 0 5 .6 .6 .6 .3", roughness), 1 - plastic_albedo) +
                       sphere);
        expect_furnace(wall(test::words("void metal m 0 0 5 .6 .6 .6 .8", roughness), 1 - 0.6) + box);
    }
}

// Lobes too weak to be sampled (-st) join the diffuse part: no energy is lost.
TEST(Furnace, RoughPlasticBelowTheSpecularThreshold) {
    RenderSettings settings = test::path_settings();
    settings.specular_threshold = 0.15;
    test::TracedScene scene(wall("void plastic m 0 0 5 .6 .6 .6 .1 .2", 1 - (0.6 * 0.9 + 0.1)) + sphere,
                            settings);
    test::expect_close(seen_inside(scene, rays), black_body, bar);
}

// Fixed limits in place of Russian roulette: what they cut off is what their figures say.
TEST(Furnace, LimitsOfDepthAndWeightCostTheirShareOnly) {
    const std::string scene_text = wall("void plastic m 0 0 5 .5 .5 .5 0 0", 0.5) + sphere;
    RenderSettings settings = test::path_settings();
    settings.max_reflections = 14;
    settings.min_weight = 1e-6;
    test::TracedScene deep(scene_text, settings);
    const double rest = std::pow(0.5, 15);  // below 0.02 %
    test::expect_close(seen_inside(deep, 100), black_body * (1 - rest), bar);

    settings.max_reflections = 3;
    test::TracedScene shallow(scene_text, settings);
    test::expect_close(seen_inside(shallow, 100), black_body * (1 - std::pow(0.5, 4)), bar);

    settings.max_reflections = 100;
    settings.min_weight = 0.1;  // three bounces weigh 0.125
    test::TracedScene light(scene_text, settings);
    test::expect_close(seen_inside(light, 100), black_body * (1 - std::pow(0.5, 4)), bar);

    settings.min_weight = 1e-6;
    settings.ambient_bounces = 2;
    settings.ambient_value[0] = settings.ambient_value[1] = settings.ambient_value[2] =
        static_cast<float>(black_body);
    test::TracedScene assumed(scene_text, settings);  // -av stands for all further bounces
    test::expect_close(seen_inside(assumed, 100), black_body, bar);
}

TEST(Furnace, SmoothSurfacesEmitLessTowardsGrazing) {
    // The emissivity as a pattern: (1 - color) (1 - r) with r = s + F (1 - s), F as RADIANCE approximates it
    const test::TemporaryFolder folder;
    test::write_file(folder / "smooth.cal",
                     "f = exp(-5.85*abs(Rdot)) - 0.00287989916;\n"
                     "plastic_e = (1 - A1)*(1 - (A2 + f*(1 - A2)));\n"
                     "metal_e = (1 - A1)*(1 - f);\n");
    const std::string file = folder / "smooth.cal";
    expect_furnace(test::words("void brightfunc e 2 plastic_e", file,
                               "0 2 .4 .1\nvoid plastic m 0 0 5 .4 .4 .4 .1 0\n", "e emissive wall 1 m 0 3",
                               black_body, black_body, black_body, "\n", box));
    expect_furnace(test::words("void brightfunc e 2 metal_e", file,
                               "0 2 .7 .9\nvoid metal m 0 0 5 .7 .7 .7 .9 0\n", "e emissive wall 1 m 0 3",
                               black_body, black_body, black_body, "\n", sphere));
}

TEST(Furnace, WallsOfDifferentEmissivityAndAnObjectInside) {
    const auto part = [](const std::string& name, double reflectance) {
        const double le = (1 - reflectance) * black_body;
        return test::words("void plastic", name + "_m", "0 0 5", reflectance, reflectance, reflectance,
                           "0 0\nvoid emissive", name, "1", name + "_m", "0 3", le, le, le, "\n");
    };
    expect_furnace(part("wall", 0.3) + part("ball", 0.8) + part("shell", 0.95) + box +
                   "ball sphere object 0 0 4 .8 .8 .8 .15\nshell bubble beyond 0 0 4 0 0 0 10\n");
}

// Walls of a table: their emissivity, 1 - reflectance_dh, is linear in the angle between the table's nodes.
TEST(Furnace, WallsOfThreeTables) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "angle.cal",
                     "place = bound(0, acos(abs(Rdot))/(PI/2)*(arg(0)-1), arg(0)-1);\n"
                     "cell = min(floor(place), arg(0)-2);\n"
                     "emissivity = linterp(place - cell, arg(cell + 1), arg(cell + 2));\n");
    for (const auto& file : test::write_tables(folder)) {
        const int count = file.table->theta_r_count();
        std::string nodes = std::to_string(count);
        for (int j = 0; j < count; ++j)
            nodes += ' ' + test::words(1 - file.table->diffuse_reflectance() -
                                       file.table->lobe_reflectance_node(j));
        expect_furnace(test::words("void brightfunc e 2 emissivity", folder / "angle.cal", "0", nodes,
                                   "\nvoid nrlbrdf m 1", file.path, "0 5 1 1 1 1 .3\ne emissive wall 1 m 0 3",
                                   black_body, black_body, black_body, "\n", sphere),
                       8 * rays);
    }
}

}  // namespace
}  // namespace infra
