#include "nrlbrdf/sampler.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/error.h"
#include "nrlbrdf/models.h"
#include "support/chi_square.h"
#include "tables.h"

namespace infra {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct View {
    double theta, azimuth;
};
constexpr View views[] = {{20 * degree, 0.3}, {52 * degree, -2}, {83 * degree, 1.7}};
constexpr double alphas[] = {0.05, 0.3};

TEST(Sampler, FollowsItsDensityAndHasTheReflectanceAsMeanForAnyAlpha) {
    const auto tables = test::three_tables();
    const double level =
        test::sidak_level(1e-3, static_cast<int>(tables.size() * std::size(views) * std::size(alphas)));
    test::ChiSquareOptions options;
    for (const auto& [name, table] : tables) {
        const auto distribution = std::make_shared<const TableDistribution>(table);
        for (const View& view : views) {
            const Vec3 wo = test::direction(view.theta, view.azimuth);
            const double reflectance = table->lobe_reflectance_dh(wo.z);
            for (const double alpha : alphas) {
                SCOPED_TRACE(name + ", viewer at " + std::to_string(view.theta / degree) + " deg, alpha " +
                             std::to_string(alpha));
                const LobeSampler sampler(distribution, alpha);
                ++options.seed;
                const auto result = test::chi_square_test(
                    [&](double u1, double u2, double u3) { return sampler.sample(wo, u1, u2, u3); },
                    [&](const Vec3& wi) { return sampler.pdf(wo, wi); }, options);
                EXPECT_EQ(result.fault, "");
                EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
                EXPECT_LE(result.integral, 1 + 1e-5);
                EXPECT_NEAR(result.mean_weight, reflectance, 4 * result.weight_error);
                // The probe's share of the samples costs this much and no more: sqrt(share / (1 - share)) if
                // it brought nothing at all.
                EXPECT_LT(result.weight_deviation, std::sqrt(probe_share / (1 - probe_share)) * 1.02);
            }
        }
    }
}

TEST(Sampler, NeverReturnsMoreThanItsBound) {
    for (const auto& [name, table] : test::three_tables()) {
        const LobeSampler sampler(std::make_shared<const TableDistribution>(table), 0.1);
        const Vec3 wo = test::direction(40 * degree, 0);
        const double bound = table->lobe_reflectance_dh(wo.z) / (1 - probe_share);
        for (double u1 : {0.0, 0.06, 0.2, 0.999999})
            for (double u2 : {0.0, 0.1, 0.5, 0.99999999})
                for (double u3 : {0.0, 0.3, 0.5, 0.99999999}) {
                    const LobeSample sample = sampler.sample(wo, u1, u2, u3);
                    EXPECT_LE(sample.weight, bound * (1 + 1e-9)) << name;
                    EXPECT_GE(sample.weight, 0) << name;
                    EXPECT_NEAR(length(sample.wi), 1, 1e-12) << name;
                }
    }
}

TEST(TableDistribution, IsExactlyProportionalToLobeTimesCosine) {
    struct Sample {
        Vec3 wi;
        double weight, pdf;
    };
    const auto tables = test::three_tables();
    const double level = test::sidak_level(1e-3, static_cast<int>(tables.size()));
    for (const auto& [name, table] : tables) {
        const TableDistribution distribution(table);
        const Vec3 wo = test::direction(50 * degree, 0.5);
        const auto pdf = [&, reflectance = table->lobe_reflectance_dh(wo.z)](const Vec3& wi) {
            return table->eval_lobe(wo, wi) * wi.z / reflectance;
        };
        const auto result = test::chi_square_test(
            [&](double u1, double u2, double u3) {
                const Vec3 wi = distribution.sample(wo, u1, u2, u3);
                return Sample{wi, 1, pdf(wi)};
            },
            pdf);
        EXPECT_EQ(result.fault, "") << name;
        EXPECT_GT(result.p, level) << name;
        EXPECT_NEAR(result.integral, 1, 1e-4) << name;
    }
}

TEST(Sampler, GivesNothingWithoutLobeOrFromBelow) {
    const auto flat = std::make_shared<const BrdfTable>(tabulate(lambertian(0.4)));
    const LobeSampler none(std::make_shared<const TableDistribution>(flat), 0.2);
    EXPECT_EQ(none.sample({0, 0, 1}, 0.5, 0.5, 0.5).weight, 0);
    EXPECT_EQ(none.pdf({0, 0, 1}, {0, 0, 1}), 0);

    const auto tables = test::three_tables();
    const LobeSampler some(std::make_shared<const TableDistribution>(tables[0].second), 0.2);
    EXPECT_EQ(some.sample({0, 0.6, -0.8}, 0.5, 0.5, 0.5).weight, 0);
    EXPECT_EQ(some.pdf({0, 0.6, 0.8}, {0, 0.6, -0.8}), 0);

    // The lopsided table shows the normal viewer no lobe at all.
    const LobeSampler blind(std::make_shared<const TableDistribution>(tables[2].second), 0.2);
    EXPECT_EQ(blind.sample({0, 0, 1}, 0.5, 0.5, 0.5).weight, 0);
}

TEST(Sampler, ViewerAtThePoleIsUnbiased) {
    const auto tables = test::three_tables();
    const LobeSampler sampler(std::make_shared<const TableDistribution>(tables[0].second), 0.2);
    const Vec3 wo{0, 0, 1};
    const auto result =
        test::chi_square_test([&](double u1, double u2, double u3) { return sampler.sample(wo, u1, u2, u3); },
                              [&](const Vec3& wi) { return sampler.pdf(wo, wi); }, {.samples = 200'000});
    EXPECT_EQ(result.fault, "");
    EXPECT_GT(result.p, 1e-3);
    EXPECT_NEAR(result.mean_weight, tables[0].second->lobe_reflectance_dh(1), 4 * result.weight_error);
}

TEST(Sampler, RefusesAlphaOutOfRange) {
    const auto table = std::make_shared<const BrdfTable>(tabulate(lambertian(0.4)));
    const auto distribution = std::make_shared<const TableDistribution>(table);
    for (const double alpha : {0.0, -0.1, 1.5, std::nan("")})
        EXPECT_THROW(LobeSampler(distribution, alpha), Error);
}

// The test itself must be able to fail.
TEST(ChiSquare, RefusesAWrongDensity) {
    struct Sample {
        Vec3 wi;
        double weight, pdf;
    };
    const auto cosine = [](double u1, double u2, double) {
        const Vec3 wi = test::direction(std::acos(std::sqrt(u1)), 2 * std::numbers::pi * u2);
        return Sample{wi, 1, wi.z / std::numbers::pi};
    };
    const auto right = [](const Vec3& wi) { return wi.z / std::numbers::pi; };
    EXPECT_GT(test::chi_square_test(cosine, right).p, 1e-3);
    EXPECT_NEAR(test::chi_square_p(10.0, 5), 0.0752352, 1e-6);  // tables of the chi-square distribution
    EXPECT_NEAR(test::chi_square_p(3.0, 5), 0.6999858, 1e-6);

    const auto uniform = [](const Vec3&) { return 0.5 / std::numbers::pi; };
    const auto wrong = test::chi_square_test(cosine, uniform);
    EXPECT_LT(wrong.p, 1e-10);
    EXPECT_NE(wrong.fault, "");
}

}  // namespace
}  // namespace infra
