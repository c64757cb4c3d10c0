#include "ir/brdftab/repair.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nrlbrdf/table.h"

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;

/// Passes that share the excess between a and b; what is left then is divided out of the whole table.
constexpr int most_passes = 200;

/// Largest reflectance accepted: 1, and the rounding of a float.
constexpr double accepted = 1 + 1e-6;

/// Reflectances of the interpolated table at its nodes.
struct Reflectances {
    std::vector<double> incident, viewed;
    double largest() const {
        return std::max(*std::max_element(incident.begin(), incident.end()),
                        *std::max_element(viewed.begin(), viewed.end()));
    }
};

Reflectances reflectances(const BrdfGrid& grid, const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> wi = polar_weights(grid.theta_i_count), wr = polar_weights(grid.theta_r_count);
    Reflectances r{std::vector<double>(a.size()), std::vector<double>(b.size())};
    auto value = grid.values.begin();
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int k = 0; k < grid.phi_count; ++k)
            for (std::size_t j = 0; j < b.size(); ++j) {
                const double f = a[i] * b[j] * static_cast<double>(*value++) * 2 * pi / grid.phi_count;
                r.incident[i] += f * wr[j];
                r.viewed[j] += f * wi[i];
            }
    return r;
}

void shrink(std::vector<double>& factors, const std::vector<double>& reflectance) {
    for (std::size_t n = 0; n < factors.size(); ++n)
        if (reflectance[n] > 1) factors[n] /= std::sqrt(reflectance[n]);
}

}  // namespace

BrdfFunction symmetrized(BrdfFunction f) {
    return [f = std::move(f)](double theta_i, double phi, double theta_r) {
        return (f(theta_i, phi, theta_r) + f(theta_r, phi, theta_i)) / 2;
    };
}

BrdfFunction limited(BrdfFunction f, double limit) {
    return [f = std::move(f), limit](double theta_i, double phi, double theta_r) {
        return f(std::min(theta_i, limit), phi, std::min(theta_r, limit));
    };
}

EnergyRepair clamp_energy(BrdfGrid& grid) {
    std::vector<double> a(static_cast<std::size_t>(grid.theta_i_count), 1);
    std::vector<double> b(static_cast<std::size_t>(grid.theta_r_count), 1);
    Reflectances r = reflectances(grid, a, b);
    EnergyRepair repair{.largest_before = r.largest()};
    while (r.largest() > accepted && repair.passes < most_passes) {
        shrink(a, r.incident);
        shrink(b, r.viewed);
        r = reflectances(grid, a, b);
        ++repair.passes;
    }
    const double rest = std::max(1.0, r.largest());
    repair.largest_after = r.largest() / rest;
    if (repair.largest_before <= accepted) return repair;
    auto value = grid.values.begin();
    for (const double ai : a)
        for (int k = 0; k < grid.phi_count; ++k)
            for (const double bj : b) {
                const double factor = ai * bj / rest;
                repair.least_factor = std::min(repair.least_factor, factor);
                *value = static_cast<float>(*value * factor);
                ++value;
            }
    return repair;
}

}  // namespace infra::ir
