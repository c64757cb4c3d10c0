// VALIDATION V3, an object in a uniform surrounding of radiance L: what it sends back is its directional
// reflectance times L, and with an emission of (1 - reflectance) L it cannot be told from the surrounding.
#include <gtest/gtest.h>

#include "rt/materials/scattering.h"
#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::degree;

constexpr double room = 38.50042;  // 300 K, 8-12 um
constexpr double bar = 1e-3;
constexpr double angles[] = {0, 30, 45, 60, 75, 80, 85};

// Radiance of a plate of the modifier "m" in the surrounding, the viewer at an angle.
test::Estimate seen(test::TracedScene& scene, double angle_deg, int rays) {
    return test::seen(scene, test::view_of_plate(angle_deg * degree, 0.4), rays);
}

test::TracedScene plate_scene(const std::string& material) {
    return test::TracedScene(material + test::plate + test::surrounding(room), test::bounce_settings(1));
}

// source: doc/materials of RADIANCE; F is its approximation of Fresnel reflection.
double plastic_albedo(double color, double specularity, bool smooth, double cosine) {
    const double f = smooth ? fresnel_approximation(cosine) : 0;
    const double reflected = specularity + f * (1 - specularity);
    return color * (1 - reflected) + reflected;
}
double metal_albedo(double color, bool smooth, double cosine) {
    const double f = smooth ? fresnel_approximation(cosine) : 0;
    return color * (1 - f) + f;
}

struct Case {
    double color, specularity, roughness;
};
constexpr Case cases[] = {{0.1, 0, 0},      {0.5, 0, 0},     {0.9, 0, 0},   {0.3, 0.05, 0},
                          {0.3, 0.05, 0.1}, {0.8, 0.4, 0.3}, {0.6, 0.9, 0}, {0.6, 0.9, 0.2}};

TEST(Albedo, OfPlasticAndMetal) {
    for (const Case& c : cases) {
        const std::string arguments =
            test::words(" m 0 0 5", c.color, c.color, c.color, c.specularity, c.roughness);
        auto plastic = plate_scene("void plastic" + arguments);
        auto metal = plate_scene("void metal" + arguments);
        const bool fresnel = c.roughness == 0 && c.specularity > 0.02;
        for (const double angle : angles) {
            SCOPED_TRACE(arguments + "at " + std::to_string(angle) + " deg");
            const double cosine = std::cos(angle * degree);
            test::expect_close(seen(plastic, angle, 50),
                               room * plastic_albedo(c.color, c.specularity, fresnel, cosine), bar);
            test::expect_close(seen(metal, angle, 50), room * metal_albedo(c.color, fresnel, cosine), bar);
        }
    }
}

// Nothing is lost or gained between the ways a sheet can send light: all it does not colour comes back.
TEST(Albedo, OfTransCountsBothSides) {
    for (const double roughness : {0.0, 0.2})
        for (const double angle : angles) {
            auto trans = plate_scene(test::words("void trans m 0 0 7 .8 .8 .8 .1", roughness, ".5 .4"));
            test::expect_close(seen(trans, angle, 50),
                               room * plastic_albedo(0.8, 0.1, roughness == 0, std::cos(angle * degree)),
                               bar);
        }
}

TEST(Albedo, OfTablesIsTheirReflectance) {
    const test::TemporaryFolder folder;
    for (const auto& file : test::write_tables(folder)) {
        auto scene = plate_scene("void nrlbrdf m 1 " + file.path + " 0 5 1 1 1 128 .3");
        for (const double angle : angles) {
            SCOPED_TRACE(file.name + " at " + std::to_string(angle) + " deg");
            test::expect_close(seen(scene, angle, 1800),
                               room * file.table->reflectance_dh(std::cos(angle * degree)), bar);
        }
    }
}

TEST(Albedo, WithKirchhoffsEmissionTheSurroundingIsSeen) {
    const test::TemporaryFolder folder;
    for (const auto& file : test::write_tables(folder))
        for (const double angle : angles) {
            SCOPED_TRACE(file.name + " at " + std::to_string(angle) + " deg");
            const double emitted = room * (1 - file.table->reflectance_dh(std::cos(angle * degree)));
            auto scene = plate_scene(
                test::words("void nrlbrdf m 1", file.path, "0 8 1 1 1 128 .3", emitted, emitted, emitted));
            test::expect_close(seen(scene, angle, 400), room, bar);
        }
}

}  // namespace
}  // namespace infra
