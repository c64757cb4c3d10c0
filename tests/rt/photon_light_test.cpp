// Where photons stand for light: scenes whose photons are spread evenly, so that the answer is known.
#include <gtest/gtest.h>

#include <numbers>

#include "../common/test_files.h"
#include "photon_files.h"
#include "traced_scene.h"

namespace infra {
namespace {

using test::flux_of;
using test::grey_flux;
using test::TracedScene;

constexpr double pi = std::numbers::pi;
constexpr double reflectance = 0.6;
constexpr int bandwidth = 400;  // an estimate from it is 1 + 1/800 too high
constexpr double bias = 0.00125;
constexpr int density = 40000;  // photons of a unit square

/// Light on the inside of a unit box.
struct PhotonLight : testing::Test {
    test::TemporaryFolder folder;
    RenderSettings settings = test::bounce_settings(64);
    const double irradiance = flux_of(grey_flux(99)) * density;
    const std::string box =
        test::words("void plastic grey 0 0 5", reflectance, reflectance, reflectance, "0 0\n") +
        "grey polygon floor 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n"
        "grey polygon ceiling 0 0 12 0 0 1 0 1 1 1 1 1 1 0 1\n"
        "grey polygon west 0 0 12 0 0 0 0 1 0 0 1 1 0 0 1\n"
        "grey polygon east 0 0 12 1 0 0 1 0 1 1 1 1 1 1 0\n"
        "grey polygon south 0 0 12 0 0 0 0 0 1 1 0 1 1 0 0\n"
        "grey polygon north 0 0 12 0 1 0 1 1 0 1 1 1 0 1 1\n";
    const std::string lamp =
        "void light bright 0 0 3 100 100 100\n"
        "bright sphere lamp 0 0 4 .5 .5 .8 .05\n";

    // Beyond the edges of each wall too, so that no estimate meets an edge.
    std::string box_of_photons(const std::string& word, bool caustic = false) {
        constexpr double beyond = 0.2;
        const double side = 1 + 2 * beyond;
        const auto count = static_cast<std::size_t>(density * side * side);
        std::vector<Photon> all;
        for (int axis = 0; axis < 3; ++axis)
            for (const int end : {0, 1}) {
                Vec3 corner(-beyond), normal(0), u(0), v(0);
                corner[axis] = end;
                normal[axis] = end ? -1 : 1;
                u[(axis + 1) % 3] = v[(axis + 2) % 3] = side;
                const auto wall = test::on_plane(corner, u, v, normal, count, grey_flux(99),
                                                 static_cast<std::uint64_t>(2 * axis + end), caustic);
                all.insert(all.end(), wall.begin(), wall.end());
            }
        const std::string path = folder / word;
        test::write_photon_map(path, word, all);
        return path;
    }
    void use(const std::string& path) { settings.photon_maps.push_back({path, bandwidth, bandwidth}); }

    /// Of the floor, seen from within the box or at a slant.
    test::Estimate seen(const std::string& rad, int count = 200) {
        TracedScene scene(rad, settings);
        return scene.mean_radiance(count, [](RandomStream& random) {
            const double x = random.uniform(), y = random.uniform();
            return test::RaySpec{{0.1 + 0.8 * x, 0.05 + 0.8 * y, 0.5}, {0, 0.1, -1}};
        });
    }
    /// The radiance of a wall that irradiance falls on.
    double reflected() const { return reflectance * irradiance / pi; }
};

TEST_F(PhotonLight, GlobalPhotonsSeenAtOnce) {
    use(box_of_photons("Global"));
    settings.ambient_bounces = -1;
    test::expect_close(seen(box), reflected() * (1 + bias), 0.02);
}

TEST_F(PhotonLight, GlobalPhotonsEndABounce) {
    use(box_of_photons("Global"));
    for (const int bounces : {1, 3}) {
        settings.ambient_bounces = bounces;
        test::expect_close(seen(box, 20), reflectance * reflected() * (1 + bias), 0.01);
    }
    settings.ambient_bounces = 0;
    EXPECT_EQ(seen(box, 4).mean, 0);
}

TEST_F(PhotonLight, PrecomputedPhotonsHoldRadiance) {
    use(box_of_photons("PreComp"));
    settings.ambient_bounces = -1;
    test::expect_close(seen(box), reflectance * flux_of(grey_flux(99)), 1e-5);
}

TEST_F(PhotonLight, CausticsAreAddedWhereTheEyeLooks) {
    use(box_of_photons("Caustic"));
    settings.ambient_bounces = 0;
    test::expect_close(seen(box), reflected() * (1 + bias), 0.02);
    // Without other photons also at the end of a bounce
    settings.ambient_bounces = 1;
    test::expect_close(seen(box, 20), reflected() * (1 + reflectance) * (1 + bias), 0.02);
    // Global photons have them
    use(box_of_photons("Global"));
    test::expect_close(seen(box, 20), reflected() * (1 + reflectance) * (1 + bias), 0.02);
    settings.ambient_bounces = -1;
    test::expect_close(seen(box), reflected() * (1 + bias), 0.02);
}

TEST_F(PhotonLight, ContributionPhotonsServeAsBoth) {
    use(box_of_photons("Contrib", false));
    settings.ambient_bounces = 0;
    EXPECT_EQ(seen(box, 4).mean, 0);
    settings.ambient_bounces = 1;
    test::expect_close(seen(box, 20), reflectance * reflected() * (1 + bias), 0.02);
    settings.photon_maps.clear();
    use(box_of_photons("Contrib", true));
    test::expect_close(seen(box, 20), reflected() * (1 + reflectance) * (1 + bias), 0.02);
}

TEST_F(PhotonLight, DirectPhotonsStandForLamps) {
    use(box_of_photons("Direct"));
    settings.ambient_bounces = -1;
    test::expect_close(seen(box + lamp), reflected() * (1 + bias), 0.02);
}

TEST_F(PhotonLight, GlassAndMirrorsGiveNoDirectLightWhereCausticsDo) {
    const std::string pane =
        "void glass clear 0 0 3 .9 .9 .9\n"
        "clear polygon pane 0 0 12 -1 -1 .6 2 -1 .6 2 2 .6 -1 2 .6\n";
    const std::string virtual_lamp =
        "void mirror silver 0 0 3 .9 .9 .9\n"
        "silver polygon glass 0 0 12 0 .01 0 0 .01 1 1 .01 1 1 .01 0\n";
    settings.ambient_bounces = -1;
    const double through = seen(box + lamp + pane, 20).mean;
    const double twice = seen(box + lamp + virtual_lamp, 20).mean;
    const double once = seen(box + lamp, 20).mean;
    EXPECT_GT(through, 0.5 * once);
    EXPECT_GT(twice, 1.1 * once);
    use(box_of_photons("Caustic"));
    const double caustic = reflected() * (1 + bias);
    EXPECT_NEAR(seen(box + lamp + pane, 200).mean, caustic, 0.02 * caustic);
    EXPECT_NEAR(seen(box + lamp + virtual_lamp, 200).mean, once + caustic, 0.02 * (once + caustic));
}

TEST_F(PhotonLight, BouncesEndAtPanesWhereCausticsDo) {
    const std::string pane =
        "void glass clear 0 0 3 .9 .9 .9\n"
        "clear polygon pane 0 0 12 0 0 .7 1 0 .7 1 1 .7 0 1 .7\n";
    use(box_of_photons("Global"));
    const double with = seen(box + pane, 50).mean;
    use(box_of_photons("Caustic"));
    const double without = seen(box + pane, 50).mean - reflected() * (1 + bias);
    EXPECT_GT(with, 1.1 * without);
    EXPECT_GT(without, 0.3 * with);
}

TEST_F(PhotonLight, FogScattersPhotons) {
    constexpr std::size_t count = 200000;
    RandomStream random(3, 3);
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        photons.push_back(test::photon({2 * x - 0.5, 2 * y - 0.5, 2 * z - 0.5}, {0, 0, 1}, grey_flux(99)));
    }
    const std::string path = folder / "fog";
    test::write_photon_map(path, "Volume", photons);
    use(path);
    settings.ambient_bounces = 0;
    settings.medium_step = 0.05;
    for (float& e : settings.extinction) e = 0.7f;
    for (float& a : settings.scattering_albedo) a = 0.5f;
    TracedScene scene(box, settings);
    const test::Estimate estimate = scene.mean_radiance(300, [](RandomStream& r) {
        return test::RaySpec{{r.uniform(), r.uniform(), 1}, {0, 0, -1}};
    });
    const double isotropic = flux_of(grey_flux(99)) * count / 8 / (4 * pi);
    // extinction times albedo times the integral of what is left on the way
    test::expect_close(estimate, isotropic * 0.5 * (1 - std::exp(-0.7)), 0.02);
}

TEST_F(PhotonLight, SpectraAreRefused) {
    use(box_of_photons("Global"));
    EXPECT_EQ(test::error_of([&] { TracedScene(box, settings, Channels::spectral(8, 400, 800)); }),
              "photon maps hold red, green and blue, not spectra (leave -cs and -cw out)");
}

}  // namespace
}  // namespace infra
