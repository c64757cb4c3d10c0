// Analytic models against closed forms, published figures and quadrature.
#include <gtest/gtest.h>

#include <cmath>

#include "nrlbrdf/coating_models.h"
#include "nrlbrdf/fresnel.h"
#include "nrlbrdf/half_vector.h"
#include "nrlbrdf/sea_model.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::degree;
using test::pi;

/// The integral of f cos(theta_r) over the reflected hemisphere, by the midpoint rule.
double reflectance_from(const BrdfFunction& f, double theta_i) {
    constexpr int steps = 600;
    double total = 0;
    for (int j = 0; j < steps; ++j) {
        const double theta = pi / 2 * (j + 0.5) / steps;
        double ring = 0;
        for (int k = 0; k < steps; ++k) ring += f(theta_i, pi * (k + 0.5) / steps, theta);
        total += ring * std::sin(theta) * std::cos(theta);
    }
    return total * (pi / 2 / steps) * (2 * pi / steps);
}

void expect_reciprocal(const BrdfFunction& f) {
    for (int i = 0; i < 90; i += 7)
        for (int phi = 0; phi < 360; phi += 25)
            for (int r = 0; r < 90; r += 7) {
                const double one = f(i * degree, phi * degree, r * degree);
                ASSERT_GE(one, 0);
                EXPECT_NEAR(f(r * degree, phi * degree, i * degree), one, 1e-9 * one);
            }
}

TEST(Fresnel, EmissivityOfFlatWater) {  // VALIDATION V9
    struct Row {
        double n, k, emissivity[3];
    };
    for (const Row& row :
         {Row{1.351, 0.0046, {0.97771, 0.93694, 0.64633}}, Row{1.218, 0.0508, {0.98982, 0.96124, 0.69723}},
          Row{1.111, 0.199, {0.98845, 0.94888, 0.64311}}}) {
        const double angles[] = {0, 60, 80};
        for (int a = 0; a < 3; ++a)
            EXPECT_NEAR(1 - fresnel_reflectance(std::cos(angles[a] * degree), row.n, row.k),
                        row.emissivity[a], 1e-5);
    }
    EXPECT_NEAR(fresnel_reflectance(0, 1.3, 0.1), 1, 1e-12);
}

TEST(SeaModel, EmissivityUnderWind) {  // VALIDATION V10
    const Sea breeze{5, 1.218, 0.0508}, gale{15, 1.218, 0.0508};
    EXPECT_NEAR(sea_emissivity(breeze, 0), 0.9898, 5e-4);
    EXPECT_NEAR(sea_emissivity(breeze, 60 * degree), 0.9566, 5e-4);
    EXPECT_NEAR(sea_emissivity(breeze, 80 * degree), 0.7664, 5e-4);
    EXPECT_NEAR(sea_emissivity(gale, 0), 0.9897, 5e-4);
    EXPECT_NEAR(sea_emissivity(gale, 60 * degree), 0.9511, 5e-4);
    EXPECT_NEAR(sea_emissivity(gale, 80 * degree), 0.8301, 5e-4);
    EXPECT_TRUE(std::isfinite(sea_emissivity(breeze, pi / 2)));
}

TEST(SeaModel, ReflectsWhatItDoesNotEmitWhereWavesDoNotShadow) {
    const Sea sea;
    const BrdfFunction f = cox_munk(sea);
    expect_reciprocal(f);
    for (const int angle : {0, 20, 40})
        EXPECT_NEAR(reflectance_from(f, angle * degree), 1 - sea_emissivity(sea, angle * degree), 5e-5);
    EXPECT_LT(reflectance_from(f, 80 * degree), 1 - sea_emissivity(sea, 80 * degree));
}

TEST(HalfVector, KnowsMirrorAndRetroDirections) {
    const HalfVector mirror = half_vector(0.7, pi, 0.7);
    EXPECT_NEAR(mirror.theta_h, 0, 1e-12);
    EXPECT_NEAR(mirror.theta_d, 0.7, 1e-12);
    const HalfVector retro = half_vector(0.7, 0, 0.7);
    EXPECT_NEAR(retro.theta_h, 0.7, 1e-12);
    EXPECT_NEAR(retro.theta_d, 0, 1e-12);
    const HalfVector grazing = half_vector(pi / 2, pi, pi / 2);
    EXPECT_NEAR(grazing.theta_h, 0, 1e-6);
    EXPECT_NEAR(half_vector(0.3, 1, 0.9).cos_imbalance, -half_vector(0.9, 1, 0.3).cos_imbalance, 1e-15);
}

TEST(SandfordRobertson, ReflectsWhatItDoesNotEmit) {
    const SandfordRobertson model{.emissivity = 0.5, .diffuse = 0.3, .grazing = 0.2, .width = 0.3};
    const BrdfFunction f = sandford_robertson(model);
    for (const int angle : {0, 30, 60, 75})
        EXPECT_NEAR(reflectance_from(f, angle * degree),
                    1 - model.emissivity * model.falloff(angle * degree) / model.falloff_mean(), 2e-4);
}

TEST(SandfordRobertson, FalloffMeanIsItsIntegral) {
    const SandfordRobertson model{.grazing = 0.37};
    double total = 0;
    constexpr int steps = 10000;
    for (int n = 0; n < steps; ++n) {
        const double theta = pi / 2 * (n + 0.5) / steps;
        total += 2 * model.falloff(theta) * std::sin(2 * theta) / 2 * (pi / 2 / steps);
    }
    EXPECT_NEAR(model.falloff_mean(), total, 1e-7);
}

TEST(BeardMaxwell, IsReciprocalAndHasItsLimits) {
    const BeardMaxwell model{.n = 1.5, .k = 0.1, .bias = 0.05, .sigma = 0.2, .diffuse = 0.1, .volume = 0.02};
    expect_reciprocal(beard_maxwell(model));
    // At normal incidence and reflection: R(0) B/(4 sigma^2) + rho/pi + rho_V.
    EXPECT_NEAR(beard_maxwell(model)(0, 0, 0),
                fresnel_reflectance(1, 1.5, 0.1) * 0.05 / (4 * 0.04) + 0.1 / pi + 0.02, 1e-12);
}

TEST(Ggx, IsReciprocalAndConservesEnergy) {
    constexpr double perfect_k = 1e6;  // a conductor that reflects all: what is missing is masked
    for (const double alpha : {0.1, 0.3, 0.6}) {
        const BrdfFunction f = ggx(0, alpha, 1, perfect_k);
        expect_reciprocal(f);
        for (const int angle : {0, 30, 60}) EXPECT_LE(reflectance_from(f, angle * degree), 1);
    }
    // f = 1/(2 pi (1 + cos theta_r)) at alpha = 1 and normal incidence, whose reflectance is 1 - ln 2.
    EXPECT_NEAR(reflectance_from(ggx(0, 1, 1, perfect_k), 0), 1 - std::log(2.0), 1e-5);
}

}  // namespace
}  // namespace infra::ir
