// Repairs and reports on tables whose faults are known.
#include "ir/brdftab/repair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ir/brdftab/quality.h"
#include "nrlbrdf/coating_models.h"
#include "nrlbrdf/sea_model.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::pi;

const BrdfFunction lopsided = [](double theta_i, double, double theta_r) {
    return 0.1 + 0.02 * theta_i + 0.05 * theta_r * theta_r;
};

TEST(Symmetrized, IsReciprocalAndKeepsWhatWas) {
    const BrdfFunction f = symmetrized(lopsided);
    EXPECT_DOUBLE_EQ(f(0.3, 1, 0.8), f(0.8, 1, 0.3));
    EXPECT_DOUBLE_EQ(f(0.3, 1, 0.8), (lopsided(0.3, 1, 0.8) + lopsided(0.8, 1, 0.3)) / 2);
}

TEST(ReciprocityError, IsZeroOrKnown) {
    EXPECT_EQ(reciprocity_error(BrdfTable(tabulate(lambertian(0.5), {5, 4, 5}))).rms, 0);
    EXPECT_LT(reciprocity_error(BrdfTable(tabulate(cox_munk({}), {5, 4, 5}))).largest, 1e-6);
    // f = 2 + theta_i - theta_r at the ends: a difference of pi over a mean of 2.
    const Difference d = reciprocity_error(
        BrdfTable(tabulate([](double i, double, double r) { return 2 + i - r; }, {5, 4, 5})));
    EXPECT_NEAR(d.largest, pi / 2, 1e-6);
    EXPECT_GT(d.rms, 0.3);
}

TEST(InterpolationError, IsZeroForWhatATableHoldsExactly) {
    const BrdfFunction linear = [](double i, double, double r) { return 1 + i + r; };
    EXPECT_LT(interpolation_error(BrdfTable(tabulate(linear, {5, 8, 5})), linear).largest, 1e-6);
    const BrdfFunction lobe = gaussian_lobe(0, 0.5, 0.2);
    const double coarse = interpolation_error(BrdfTable(tabulate(lobe, {10, 18, 10})), lobe).rms;
    const double fine = interpolation_error(BrdfTable(tabulate(lobe, {37, 72, 37})), lobe).rms;
    EXPECT_LT(fine, coarse / 4);
}

TEST(ClampEnergy, LeavesSoundTablesAlone) {
    BrdfGrid grid = tabulate(lambertian(1), {10, 12, 10});
    const std::vector<float> before = grid.values;
    const EnergyRepair repair = clamp_energy(grid);
    EXPECT_EQ(repair.passes, 0);
    EXPECT_NEAR(repair.largest_before, 1, 1e-6);
    EXPECT_EQ(grid.values, before);
}

TEST(ClampEnergy, ClampsAndStaysReciprocal) {
    BrdfGrid grid = tabulate(limited(ggx(0.5, 0.3, 1, 20), 1.5), {19, 36, 19});
    EXPECT_GT(largest_reflectance(BrdfTable(grid)), 1.2);
    const EnergyRepair repair = clamp_energy(grid);
    const BrdfTable table(grid);
    EXPECT_GT(repair.passes, 0);
    EXPECT_LT(repair.least_factor, 1);
    EXPECT_LE(largest_reflectance(table), 1 + 1e-5);
    EXPECT_LT(reciprocity_error(table).largest, 1e-4);
}

TEST(ClampEnergy, WorksWithUnequalCountsAndOneWayFaults) {
    BrdfGrid grid = tabulate([](double i, double, double r) { return 0.5 + i - 0.2 * r; }, {7, 4, 12});
    clamp_energy(grid);
    EXPECT_LE(largest_reflectance(BrdfTable(grid)), 1 + 1e-5);
}

}  // namespace
}  // namespace infra::ir
