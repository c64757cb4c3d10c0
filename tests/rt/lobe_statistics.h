// What the tests of all lobes measure: do samples follow a density, and what does a function integrate to.
#pragma once

#include <cmath>
#include <numbers>

#include "rt/lobes/lobe.h"
#include "support/chi_square.h"

namespace infra::test {

/// Runs the chi-square test of a lobe; density: what its samples should follow.
template <class Density>
ChiSquareResult sample_lobe(const Lobe& lobe, int count, const Density& density, bool whole_sphere,
                            std::uint64_t seed) {
    struct Draw {
        Vec3 wi;
        double weight, pdf;
    };
    RandomStream random(7, seed);
    const auto draw = [&](double, double, double) {
        const LobeDraw drawn = lobe.sample(random, 0, count);
        return Draw{drawn.wi, drawn.weight, drawn.weight > 0 ? density(drawn.wi) : 0};
    };
    ChiSquareOptions options;
    options.samples = 300'000;
    options.full_sphere = whole_sphere;
    options.cos_cells = whole_sphere ? 20 : 10;
    return chi_square_test(draw, density, options);
}

/// Integral over the upper (side 1) or lower (side -1) hemisphere.
template <class Function>
double hemisphere_integral(const Function& f, double side) {
    double sum = 0;
    constexpr int cells = 10;
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column)
            sum += integrate_cell(
                [&](double c, double phi) {
                    const double s = std::sqrt(std::max(0.0, 1 - c * c));
                    return f(Vec3{s * std::cos(phi), s * std::sin(phi), c * side});
                },
                row / double{cells}, (row + 1) / double{cells}, column * 2 * std::numbers::pi / cells,
                (column + 1) * 2 * std::numbers::pi / cells, 1e-6);
    return sum;
}

}  // namespace infra::test
