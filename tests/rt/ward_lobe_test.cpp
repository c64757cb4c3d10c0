#include <gtest/gtest.h>

#include <numbers>

#include "lobe_statistics.h"
#include "rt/lobes/ward.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
constexpr double view_angles[] = {0, 30, 60, 80};
constexpr FacetSlopes roughnesses[] = {{0.03, 0.03}, {0.1, 0.1}, {0.3, 0.3}, {0.05, 0.3}, {0.4, 0.1}};
constexpr int case_count = static_cast<int>(std::size(view_angles) * std::size(roughnesses));
constexpr int several = 2;  // samples of a lobe: more than one are weighted, a single one is not

WardSetting setting(double view_deg, const FacetSlopes& roughness, const Vec3& shading_normal = {0, 0, 1}) {
    SurfaceFrame frame;
    frame_along({0.8, 0.6, 0}, shading_normal, frame);
    return {.view_direction = -test::direction(view_deg * degree, 0.7),
            .frame = frame,
            .surface_normal = {0, 0, 1},
            .roughness = roughness,
            .specular_samples = 1};
}

template <class Body>
void for_all_cases(const Body& body) {
    std::uint64_t number = 0;
    for (const double view : view_angles)
        for (const FacetSlopes& roughness : roughnesses) {
            SCOPED_TRACE("viewer at " + std::to_string(view) + " deg, roughness " +
                         std::to_string(roughness.u) + " by " + std::to_string(roughness.v));
            body(view, roughness, ++number);
        }
}

TEST(WardReflection, OneOfSeveralSamplesFollowsPdfAndCarriesEval) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](double view, const FacetSlopes& roughness, std::uint64_t number) {
        const WardReflection lobe(Spectrum(3, 1), setting(view, roughness), 0);
        const auto result = test::sample_lobe(
            lobe, several, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_LE(result.integral, 1 + 1e-5);
        const double albedo = test::hemisphere_integral([&](const Vec3& wi) { return lobe.eval(wi, 0); }, 1);
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

TEST(WardReflection, ASingleSampleFollowsPdfAndWeighsOne) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](double view, const FacetSlopes& roughness, std::uint64_t number) {
        const WardReflection lobe(Spectrum(3, 1), setting(view, roughness), 0);
        const auto result = test::sample_lobe(
            lobe, 1, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_NEAR(result.mean_weight, result.integral, 4 * result.weight_error + 1e-5);
    });
}

TEST(WardReflection, ATexturedNormalSendsNoSampleIntoTheSurface) {
    const Vec3 tilted = normalize(Vec3{-0.23, -0.19, 1});  // away from the viewer
    const WardReflection lobe(Spectrum(3, 1), setting(55, {0.2, 0.2}, tilted), 0);
    const auto result = test::sample_lobe(
        lobe, several, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, 1);
    EXPECT_EQ(result.fault, "");
    EXPECT_GT(result.p, 1e-3);
    EXPECT_LT(result.integral, 0.999);  // some are lost
}

TEST(WardReflection, IsReciprocal) {
    RandomStream random(3, 3);
    for (const FacetSlopes& roughness : roughnesses)
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
    const WardReflection sharp(Spectrum(3, 1), setting(30, {0.1, 0.1}), 0),
        soft(Spectrum(3, 1), setting(30, {0.1, 0.1}), 1);
    constexpr double omega = 0.2;
    EXPECT_EQ(sharp.eval(mirror, omega), sharp.eval(mirror, 0));
    EXPECT_EQ(soft.eval(mirror, 0), sharp.eval(mirror, 0));
    const double wider = 0.01 + omega / (4 * std::numbers::pi);  // squared slope
    EXPECT_NEAR(soft.eval(mirror, omega) / sharp.eval(mirror, 0), 0.01 / wider, 1e-12);
}

TEST(WardTransmission, SamplesFollowTheirDensity) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](double view, const FacetSlopes& roughness, std::uint64_t number) {
        const WardSetting s = setting(view, roughness);
        const WardTransmission lobe(Spectrum(3, 1), s, s.view_direction);
        const auto result = test::sample_lobe(
            lobe, 1, [&](const Vec3& wi) { return lobe.pdf(wi); }, true, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_NEAR(result.integral, 1, 1e-4);
        EXPECT_NEAR(result.mean_weight, 1, 1e-6);
    });
}

TEST(WardReflection, OfEqualSlopesIsTheSameAllAround) {
    RandomStream random(4, 4);
    for (int n = 0; n < 1000; ++n) {
        WardSetting turned = setting(40, {0.2, 0.2});
        turned.frame = frame_around(turned.frame.normal);
        const Vec3 wi = test::direction(89 * degree * random.uniform(), 6 * random.uniform());
        const double a = WardReflection(Spectrum(3, 1), setting(40, {0.2, 0.2}), 1).eval(wi, 0.01);
        EXPECT_NEAR(WardReflection(Spectrum(3, 1), turned, 1).eval(wi, 0.01), a, 1e-9 * (1 + a));
    }
}

// What a thermal surface of several samples takes its reflectance to be.
TEST(WardEnergy, IsTheMeanOfWhatTheTracerAddsUp) {
    constexpr int count = 8, rounds = 20'000;
    for (const FacetSlopes& roughness : {FacetSlopes{0.1, 0.1}, {0.05, 0.4}, {0.5, 0.2}}) {
        const WardEnergy energy(roughness);
        for (const double view : {10.0, 50.0, 75.0, 84.0}) {
            SCOPED_TRACE(std::to_string(roughness.u) + " by " + std::to_string(roughness.v) + " at " +
                         std::to_string(view) + " deg");
            WardSetting s = setting(view, roughness);
            s.energy = &energy;
            const WardReflection lobe(Spectrum(3, 1), s, 0);
            RandomStream random(5, 5);
            test::Mean mean;
            for (int n = 0; n < rounds; ++n) {
                double sum = 0;
                int draws = 0;
                for (int traced = 0; traced < count && draws < 10 * count; ++draws) {
                    const LobeDraw draw = lobe.sample(random, draws, count);
                    sum += draw.weight;
                    traced += draw.weight > 0;
                }
                mean.add(sum / draws);
            }
            const test::Estimate estimate = mean.estimate();
            EXPECT_NEAR(lobe.mean_weight(count), estimate.mean, 4 * estimate.error + 1e-3);
        }
    }
}

// RADIANCE evaluates another lobe for light sources than it samples; both carry the same energy straight on.
TEST(WardTransmission, EvalCarriesAllEnergyForTheNormalViewer) {
    for (const double roughness : {0.03, 0.1}) {
        const WardSetting s = setting(0, {roughness, roughness});
        const WardTransmission lobe(Spectrum(3, 1), s, s.view_direction);
        EXPECT_NEAR(test::hemisphere_integral([&](const Vec3& wi) { return lobe.eval(wi, 0); }, -1), 1, 0.01);
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
