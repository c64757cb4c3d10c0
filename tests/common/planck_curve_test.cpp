// The tabulated Planck curve against the integral that it stands for.
#include "common/planck/planck_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.h"
#include "common/planck/planck.h"

namespace infra {
namespace {

TEST(PlanckCurve, FollowsTheBandRadiance) {
    for (const auto& [lo, hi] : {std::pair{3.0, 5.0}, {8.0, 12.0}, {0.4, 0.7}, {8.0, 8.01}, {20.0, 1000.0}}) {
        const PlanckCurve curve(lo, hi);
        for (double temperature = 5; temperature < 20000; temperature *= 1.0173) {
            const double exact = band_radiance(temperature, lo, hi);
            // Below the smallest float there is nothing to be exact about.
            if (exact < 1e-45) continue;
            EXPECT_NEAR(curve.radiance(temperature) / exact, 1, 1e-8)
                << temperature << " K in " << lo << "-" << hi << " um";
        }
    }
}

TEST(PlanckCurve, IsDarkWhereNothingIsLeft) { EXPECT_EQ(PlanckCurve(0.2, 0.3).radiance(21.0), 0); }

TEST(PlanckCurve, RefusesReversedBands) { EXPECT_THROW(PlanckCurve(12, 8), Error); }

}  // namespace
}  // namespace infra
