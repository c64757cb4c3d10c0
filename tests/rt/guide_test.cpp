// Rays sent to what is bright: they follow their density, change no mean, and take most of the noise away.
#include "rt/guiding/guide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "rt/guiding/hot_spots.h"
#include "test_tables.h"
#include "traced_scene.h"

namespace infra::test {
namespace {

constexpr double pi = std::numbers::pi;

DirectionMap sky_with_bright_band() {
    std::vector<double> weights(DirectionMap::cells);
    for (int cell = 0; cell < DirectionMap::cells; ++cell) {
        const Vec3 d = DirectionMap::direction(cell, 0.5, 0.5);
        weights[static_cast<std::size_t>(cell)] = d.z > 0 ? std::exp(-10 * d.z) * (1.2 + d.x) : 0.0;
    }
    return DirectionMap(weights);
}

TEST(AliasTable, DrawsInProportion) {
    const std::vector<double> weights = {1, 0, 5, 2, 0.5};
    const AliasTable table(weights);
    std::vector<double> counts(weights.size());
    constexpr int draws = 100000;
    for (int i = 0; i < draws; ++i) {
        double u = (i + 0.5) / draws;
        const std::size_t k = table.draw(u);
        ASSERT_GE(u, 0);
        ASSERT_LE(u, 1);
        ++counts[k];
    }
    for (std::size_t k = 0; k < weights.size(); ++k)
        EXPECT_NEAR(counts[k] / draws, weights[k] / 8.5, 2.0 * weights.size() / draws);
}

TEST(DirectionMap, CellsAndDirectionsAgree) {
    for (int cell = 0; cell < DirectionMap::cells; cell += 977)
        EXPECT_EQ(DirectionMap::cell_of(DirectionMap::direction(cell, 0.3, 0.7)), cell);
    EXPECT_LT(DirectionMap::cell_of(Vec3(0, 0, 1)), DirectionMap::cells);
    EXPECT_GE(DirectionMap::cell_of(Vec3(0, 0, -1)), 0);
}

TEST(Lookout, SamplesFollowTheirDensity) {
    const Guide guide(sky_with_bright_band(), 2.0,
                      {{.center = Vec3(3, 0, 1), .radius = 1, .excess = 10},
                       {.center = Vec3(0, 0, 0.5), .radius = 2, .excess = 1},  // around the point
                       {.center = normalize(Vec3(-1, 1, 1)), .radius = 0.9, .excess = 1, .distant = true}});
    const Lookout lookout(guide, Vec3(0));
    // Shares of cells: of samples, and of the density integrated by even directions.
    constexpr int rows = 8, columns = 16, draws = 400'000, looks = 4'000'000;
    std::vector<double> drawn(rows * columns), sum(rows * columns), squares(rows * columns);
    const auto cell_of = [](const Vec3& d) {
        const int row = std::min(static_cast<int>((d.z + 1) / 2 * rows), rows - 1);
        const int column =
            std::min(static_cast<int>((std::atan2(d.y, d.x) / (2 * pi) + 0.5) * columns), columns - 1);
        return static_cast<std::size_t>(row * columns + column);
    };
    RandomStream random(7, 1);
    for (int i = 0; i < draws; ++i) {
        const double u = random.uniform();
        const Vec3 d = lookout.sample(u, random.uniform());
        ASSERT_NEAR(length(d), 1, 1e-12);
        ASSERT_GT(lookout.pdf(d), 0);
        ++drawn[cell_of(d)];
    }
    for (int i = 0; i < looks; ++i) {
        const Vec3 d = direction(std::acos(1 - 2 * random.uniform()), 2 * pi * random.uniform());
        const double value = 4 * pi * lookout.pdf(d);
        sum[cell_of(d)] += value;
        squares[cell_of(d)] += value * value;
    }
    EXPECT_NEAR(std::accumulate(sum.begin(), sum.end(), 0.0) / looks, 1, 0.01);
    for (std::size_t c = 0; c < drawn.size(); ++c) {
        const double share = sum[c] / looks;
        const double error = std::hypot(std::sqrt(squares[c]) / looks, std::sqrt(share / draws));
        EXPECT_NEAR(drawn[c] / draws, share, 4.5 * error + 1e-6) << "cell " << c;
    }
}

TEST(HotSpots, GroupsLieWhereTheBallsDo) {
    std::vector<HotSpot> balls;
    for (int i = 0; i < 200; ++i)
        balls.push_back({.center = Vec3(i % 2 ? 0.0 : 100.0, 0.01 * i, 0), .radius = 0.1, .excess = 1});
    const auto two = group_spots(balls, 2);
    ASSERT_EQ(two.size(), 2u);
    for (const HotSpot& spot : two) {
        EXPECT_DOUBLE_EQ(spot.excess, 100);
        EXPECT_LT(spot.radius, 1.3);
    }
    const auto many = group_spots(balls, 32);
    EXPECT_LE(many.size(), 32u);
    for (const HotSpot& ball : balls) {
        bool covered = false;
        for (const HotSpot& spot : many)
            covered = covered || length(spot.center - ball.center) + 0.1 <= spot.radius + 1e-9;
        EXPECT_TRUE(covered);
    }
}

TEST(Guide, NothingStandsOutOfEvenLight) {
    RenderSettings settings = bounce_settings(16);
    settings.guided_samples = 16;
    TracedScene scene(surrounding(1) + "void plastic grey 0 0 5 .5 .5 .5 0 0 grey sphere ball 0 0 4 0 0 0 1",
                      settings);
    EXPECT_EQ(scene.compiled().guide(), nullptr);
}

// A bright spot in the sky, a small sun that is a glow, a hot plate.
const char* const bright_scene =
    "void brightfunc spot 2 if(Dz*.8+Dx*.6-.999,400,1+Dz) . 0 0 \n"
    "spot glow sky_glow 0 0 4 1 1 1 0 sky_glow source sky 0 0 4 0 0 1 180\n"
    "void glow sun_glow 0 0 4 3e4 3e4 3e4 0 sun_glow source sun 0 0 4 -1 0 1 .5\n"
    "void plastic grey 0 0 5 .5 .4 .3 0 0 grey polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n"
    "void emissive hot 1 grey 0 3 300 300 300 hot polygon plate 0 0 12 2 -.2 .1 2 .2 .1 2 .2 .5 2 -.2 .5\n";
/// Shows sun and sky to the floor once more, where no ray is aimed.
const char* const mirror =
    "void metal mirror 0 0 5 .9 .9 .9 1 0 mirror polygon screen 0 0 12 -1 2 0 1 2 0 1 2 2 -1 2 2\n";

class GuidedRays : public testing::Test {
  protected:
    /// Mean radiance of the floor around the origin with so many guided rays a hit.
    static Estimate seen(double guided, const std::string& more, const RenderSettings& base, int count,
                         Vec3 at = Vec3(0)) {
        RenderSettings settings = base;
        settings.guided_samples = guided;
        TracedScene scene(bright_scene + more, settings);
        EXPECT_EQ(scene.compiled().guide() != nullptr, guided > 0);
        const Vec3 from(0.3, -1, 1.5);
        return scene.mean_radiance(count, from, at - from);
    }
};

TEST_F(GuidedRays, LeaveTheMeanOfADiffuseSurface) {
    expect_same(seen(0, mirror, bounce_settings(4096), 60), seen(16, mirror, bounce_settings(16), 600));
    const Estimate aimed = seen(16, "", bounce_settings(16), 400);
    expect_same(seen(0, "", bounce_settings(4096), 60), aimed);
    // With no more rays a single hemisphere is far nearer. Few of the blind ones ever see the sun.
    const Estimate blind = seen(0, "", bounce_settings(36), 20000);
    EXPECT_LT(aimed.error * std::sqrt(400), 0.1 * blind.error * std::sqrt(20000));
}

TEST_F(GuidedRays, LeaveTheMeanOfATexturedSurface) {
    const std::string rough =
        "void texfunc tilt 4 1.2 .3 0 . 0 0 tilt plastic bumpy 0 0 5 .6 .6 .6 0 0\n"
        "bumpy ring spot 0 0 8 0 0 .01 0 0 1 0 .5\n";
    // Many rays are drawn over the true surface, few over the turned one.
    expect_same(seen(0, rough, bounce_settings(4096), 60), seen(16, rough, bounce_settings(64), 600));
    expect_same(seen(0, rough, bounce_settings(36), 60000), seen(16, rough, bounce_settings(36), 600));
}

TEST_F(GuidedRays, LeaveTheMeanOfTransmission) {
    const std::string leaf =
        "void trans leaf_m 0 0 7 .7 .7 .7 0 0 .6 0 leaf_m ring leaf 0 0 8 0 0 .6 .3 .2 -1 0 .5\n";
    expect_same(seen(0, leaf, bounce_settings(4096), 60, Vec3(0, 0, 0.6)),
                seen(16, leaf, bounce_settings(36), 600, Vec3(0, 0, 0.6)));
}

TEST_F(GuidedRays, LeaveTheMeanOfManyBounces) {
    RenderSettings paths = path_settings();
    const Estimate blind = seen(0, mirror, paths, 1000000), aimed = seen(1, mirror, paths, 30000);
    expect_same(blind, aimed);
}

TEST_F(GuidedRays, LeaveTheMeanOfLobes) {
    RenderSettings base = bounce_settings(1);
    base.ambient_bounces = 0;
    base.specular_samples = 64;
    const std::string sheet =
        "void metal sheet_m 0 0 5 .8 .6 .4 .9 .25 sheet_m ring sheet 0 0 8 0 0 .01 0 0 1 0 .5\n";
    RenderSettings many = base;
    many.specular_samples = 4096;
    const Estimate blind = seen(0, sheet, many, 200), aimed = seen(16, sheet, base, 2000);
    expect_same(blind, aimed);
    const Estimate few = seen(0, sheet, base, 2000);
    EXPECT_LT(aimed.error, 0.5 * few.error);
}

// Russian roulette may end all rays that are not guided: those that are carry on for their share.
TEST_F(GuidedRays, LeaveTheMeanWhereRouletteEndsMostRays) {
    const std::string dark = "void plastic soot 0 0 5 .1 .1 .1 0 0 soot ring spot 0 0 8 0 0 .01 0 0 1 0 .5\n";
    RenderSettings base = bounce_settings(64);
    base.max_reflections = -10;
    RenderSettings rough = base;
    rough.min_weight = 0.5;
    expect_same(seen(8, dark, base, 4000), seen(8, dark, rough, 40000));
    base.ambient_bounces = rough.ambient_bounces = 0;
    const TemporaryFolder folder;
    const std::string table = words("void nrlbrdf paint 1", write_tables(folder)[0].path,
                                    "0 5 .3 .3 .3 1 .3\n", "paint ring sheet 0 0 8 0 0 .02 0 0 1 0 .5\n");
    expect_same(seen(4, table, base, 4000), seen(4, table, rough, 40000));
}

}  // namespace
}  // namespace infra::test
