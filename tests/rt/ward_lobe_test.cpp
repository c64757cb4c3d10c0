#include <gtest/gtest.h>

#include <numbers>

#include "rt/lobes/ward.h"
#include "scene_pieces.h"
#include "support/chi_square.h"

namespace infra {
namespace {

using test::degree;
constexpr double view_angles[] = {0, 30, 60, 80};
constexpr double roughnesses[] = {0.03, 0.1, 0.3};
constexpr int case_count = static_cast<int>(std::size(view_angles) * std::size(roughnesses));
constexpr int several = 2;  // samples of a lobe: more than one are weighted, a single one is not

struct Draw {
    Vec3 wi;
    double weight, pdf;
};

WardSetting setting(double view_deg, double roughness, const Vec3& shading_normal = {0, 0, 1}) {
    return {.view_direction = -test::direction(view_deg * degree, 0.7),
            .normal = shading_normal,
            .surface_normal = {0, 0, 1},
            .alpha_squared = roughness * roughness,
            .specular_samples = 1};
}

// Runs the chi-square test of a lobe; density: what its samples should follow.
template <class Density>
test::ChiSquareResult sample_lobe(const Lobe& lobe, int count, const Density& density, bool whole_sphere,
                                  std::uint64_t seed) {
    RandomStream random(7, seed);
    const auto draw = [&](double, double, double) {
        const LobeDraw drawn = lobe.sample(random, 0, count);
        return Draw{drawn.wi, drawn.weight, drawn.weight > 0 ? density(drawn.wi) : 0};
    };
    test::ChiSquareOptions options;
    options.samples = 300'000;
    options.full_sphere = whole_sphere;
    options.cos_cells = whole_sphere ? 20 : 10;
    return test::chi_square_test(draw, density, options);
}

// Integral over the upper or lower hemisphere.
template <class Function>
double hemisphere_integral(const Function& f, double side) {
    double sum = 0;
    constexpr int cells = 10;
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column)
            sum += test::integrate_cell(
                [&](double c, double phi) {
                    const double s = std::sqrt(std::max(0.0, 1 - c * c));
                    return f(Vec3{s * std::cos(phi), s * std::sin(phi), c * side});
                },
                row / double{cells}, (row + 1) / double{cells}, column * 2 * std::numbers::pi / cells,
                (column + 1) * 2 * std::numbers::pi / cells, 1e-6);
    return sum;
}

template <class Body>
void for_all_cases(const Body& body) {
    std::uint64_t number = 0;
    for (const double view : view_angles)
        for (const double roughness : roughnesses) {
            SCOPED_TRACE("viewer at " + std::to_string(view) + " deg, roughness " +
                         std::to_string(roughness));
            body(view, roughness, ++number);
        }
}

TEST(WardReflection, OneOfSeveralSamplesFollowsPdfAndCarriesEval) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](double view, double roughness, std::uint64_t number) {
        const WardReflection lobe(Spectrum(3, 1), setting(view, roughness), 0);
        const auto result = sample_lobe(
            lobe, several, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_LE(result.integral, 1 + 1e-5);
        const double albedo = hemisphere_integral([&](const Vec3& wi) { return lobe.eval(wi, 0); }, 1);
        EXPECT_NEAR(result.mean_weight, albedo, 4 * result.weight_error + 1e-5);
        EXPECT_LE(albedo, 1 + 1e-5);

        RandomStream random(8, number);
        for (int n = 0; n < 2000; ++n) {
            const LobeDraw draw = lobe.sample(random, 0, several);
            const double eval = lobe.eval(draw.wi, 0);
            if (draw.weight <= 0 || eval <= 0) continue;
            EXPECT_NEAR(draw.weight * lobe.pdf(draw.wi) / eval, 1, 1e-5);
        }
    });
}

TEST(WardReflection, ASingleSampleIsDrawnAgainUntilItLeavesTheSurface) {
    const double level = test::sidak_level(1e-3, case_count);
    constexpr int attempts = 10;
    for_all_cases([&](double view, double roughness, std::uint64_t number) {
        const WardReflection lobe(Spectrum(3, 1), setting(view, roughness), 0);
        const double accepted = hemisphere_integral([&](const Vec3& wi) { return lobe.pdf(wi); }, 1);
        const double scale = (1 - std::pow(std::max(0.0, 1 - accepted), attempts)) / accepted;
        const auto result = sample_lobe(
            lobe, 1, [&](const Vec3& wi) { return lobe.pdf(wi) * scale; }, false, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_NEAR(result.mean_weight, accepted * scale, 1e-3) << "all energy is kept";
    });
}

TEST(WardReflection, ATexturedNormalSendsNoSampleIntoTheSurface) {
    const Vec3 tilted = normalize(Vec3{-0.23, -0.19, 1});  // away from the viewer
    const WardReflection lobe(Spectrum(3, 1), setting(55, 0.2, tilted), 0);
    const auto result = sample_lobe(
        lobe, several, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, 1);
    EXPECT_EQ(result.fault, "");
    EXPECT_GT(result.p, 1e-3);
    EXPECT_LT(result.integral, 0.999);  // some are lost
}

TEST(WardReflection, IsReciprocal) {
    RandomStream random(3, 3);
    for (const double roughness : roughnesses)
        for (int n = 0; n < 1000; ++n) {
            const auto draw = [&] {
                return test::direction(85 * degree * random.uniform(),
                                       2 * std::numbers::pi * random.uniform());
            };
            const Vec3 a = draw(), b = draw();
            WardSetting from_a = setting(0, roughness), from_b = from_a;
            from_a.view_direction = -a;
            from_b.view_direction = -b;
            const double ab = WardReflection(Spectrum(3, 1), from_a, 0).eval(b, 0) / b.z;
            const double ba = WardReflection(Spectrum(3, 1), from_b, 0).eval(a, 0) / a.z;
            EXPECT_NEAR(ab, ba, 1e-5 * std::max(ab, ba));
        }
}

TEST(WardReflection, ASourceOfSomeSizeWidensItOnlyWhenAsked) {
    const Vec3 mirror = test::direction(30 * degree, 0.7 + std::numbers::pi);
    const WardReflection sharp(Spectrum(3, 1), setting(30, 0.1), 0),
        soft(Spectrum(3, 1), setting(30, 0.1), 1);
    constexpr double omega = 0.2;
    EXPECT_EQ(sharp.eval(mirror, omega), sharp.eval(mirror, 0));
    EXPECT_EQ(soft.eval(mirror, 0), sharp.eval(mirror, 0));
    const double wider = 0.01 + omega / (4 * std::numbers::pi);  // squared slope
    EXPECT_NEAR(soft.eval(mirror, omega) / sharp.eval(mirror, 0), 0.01 / wider, 1e-12);
}

TEST(WardTransmission, SamplesFollowTheirDensity) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](double view, double roughness, std::uint64_t number) {
        const WardSetting s = setting(view, roughness);
        const WardTransmission lobe(Spectrum(3, 1), s, s.view_direction);
        const auto result = sample_lobe(
            lobe, 1, [&](const Vec3& wi) { return lobe.pdf(wi); }, true, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_NEAR(result.integral, 1, 1e-4);
        EXPECT_NEAR(result.mean_weight, 1, 1e-6);
    });
}

// RADIANCE evaluates another lobe for light sources than it samples; both carry the same energy straight on.
TEST(WardTransmission, EvalCarriesAllEnergyForTheNormalViewer) {
    for (const double roughness : {0.03, 0.1}) {
        const WardSetting s = setting(0, roughness);
        const WardTransmission lobe(Spectrum(3, 1), s, s.view_direction);
        EXPECT_NEAR(hemisphere_integral([&](const Vec3& wi) { return lobe.eval(wi, 0); }, -1), 1, 0.01);
        EXPECT_EQ(lobe.eval({0, 0, 1}, 0), 0);
    }
}

TEST(WardLobes, SampleCountFollowsSpecularSamples) {
    EXPECT_EQ(ward_sample_count(0, 1), 1);
    EXPECT_EQ(ward_sample_count(1.5, 1), 1);
    EXPECT_EQ(ward_sample_count(16, 1), 16);
    EXPECT_EQ(ward_sample_count(16, 0.5), 8);
    EXPECT_EQ(ward_sample_count(16, 0.01), 1);
}

}  // namespace
}  // namespace infra
