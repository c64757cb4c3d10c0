// How well tables stand for smooth functions: the figures that docs/brdf.md states for the smaller grids.
// brdftab prints those of the larger ones.
#include <gtest/gtest.h>

#include "ir/brdftab/quality.h"
#include "nrlbrdf/sea_model.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::degree;
using test::pi;

struct Stated {
    BrdfFunction f;
    double rms, of_peak, reflectance;
};

/// The sea held from half a step below 90 deg on, as brdftab does.
BrdfFunction held_sea(double limit) {
    return [f = cox_munk({5, 1.218, 0.0508}), limit](double theta_i, double phi, double theta_r) {
        return f(std::min(theta_i, limit), phi, std::min(theta_r, limit));
    };
}

void expect_figures(const GridCounts& counts, const std::vector<Stated>& all) {
    for (const Stated& stated : all) {
        SCOPED_TRACE(&stated - all.data());
        const BrdfTable table(tabulate(stated.f, counts));
        const Difference error = interpolation_error(table, stated.f);
        EXPECT_NEAR(error.rms, stated.rms, 0.02 * stated.rms);
        EXPECT_NEAR(error.of_peak, stated.of_peak, 0.02 * stated.of_peak);
        EXPECT_NEAR(reflectance_error(table, stated.f).largest, stated.reflectance,
                    0.02 * stated.reflectance);
    }
}

TEST(InterpolationError, IsAsStatedForTheSmallGrid) {
    expect_figures({20, 20, 40}, {{gaussian_lobe(0, 0.5, 0.05), 0.812, 0.426, 0.254},
                                  {gaussian_lobe(0, 0.5, 0.1), 0.351, 0.297, 0.0639},
                                  {gaussian_lobe(0, 0.5, 0.2), 0.124, 0.103, 0.0149},
                                  {gaussian_lobe(0, 0.5, 0.4), 0.0439, 0.075, 0.00101},
                                  {held_sea((90 - 45.0 / 39) * degree), 1.39, 0.0752, 0.457}});
}

TEST(InterpolationError, IsAsStatedForTheMiddleGrid) {
    expect_figures({45, 90, 45}, {{gaussian_lobe(0, 0.5, 0.05), 0.129, 0.137, 0.0172},
                                  {gaussian_lobe(0, 0.5, 0.1), 0.0452, 0.0736, 0.00244},
                                  {gaussian_lobe(0, 0.5, 0.2), 0.0141, 0.0225, 0.00048},
                                  {gaussian_lobe(0, 0.5, 0.4), 0.00378, 0.0059, 5.02e-5},
                                  {held_sea((90 - 45.0 / 44) * degree), 0.522, 0.0245, 0.00567}});
}

TEST(InterpolationError, FallsWithTheSquareOfTheStep) {
    const BrdfFunction f = gaussian_lobe(0, 0.5, 0.4);
    const auto error = [&](int n) {
        return interpolation_error(BrdfTable(tabulate(f, {n + 1, 4 * n, n + 1})), f);
    };
    const Difference coarse = error(16), fine = error(32);
    EXPECT_NEAR(coarse.rms / fine.rms, 4, 0.3);
    EXPECT_NEAR(coarse.of_peak / fine.of_peak, 4, 0.3);
}

TEST(ReflectanceError, OfATableAgainstItself) {
    const BrdfTable table(tabulate(gaussian_lobe(0.1, 0.5, 0.4), {19, 36, 19}));
    const BrdfFunction itself = [&](double theta_i, double phi, double theta_r) {
        return table_value(table, theta_i, phi, theta_r);
    };
    EXPECT_LT(reflectance_error(table, itself).largest, 1e-5);
    const BrdfFunction brighter = [&](double theta_i, double phi, double theta_r) {
        return table_value(table, theta_i, phi, theta_r) + 0.01 / pi;
    };
    const ReflectanceError error = reflectance_error(table, brighter);
    EXPECT_NEAR(error.largest, 0.01, 1e-5);
    EXPECT_GT(error.relative, 0.01 / 0.7);
}

}  // namespace
}  // namespace infra::ir
