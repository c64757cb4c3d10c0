// Integrals of Planck's law over the dimensionless x = c2/(wavelength temperature). Only for planck*.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace infra {

/// Over one range of x.
struct PlanckIntegral {
    double energy = 0;  ///< of x^3/(e^x - 1): in-band radiance over radiance_factor T^4
    double slope = 0;   ///< of x^4 e^x/(e^x - 1)^2: its dL/dT over radiance_factor T^3
};

/// The two integrands. x >= 0, also infinite.
inline PlanckIntegral planck_integrand(double x) {
    if (x <= 0.0 || x > 745.0) return {};  // e^-745 is the smallest double
    const double photons = 1.0 / std::expm1(x);
    const double energy = x * x * x * photons;
    return {energy, x * energy * (1.0 + photons)};
}

/// shape: 0 <= from <= to, to may be infinite.
///   source    Widger & Woodall, "Integration of the Planck blackbody radiation function", Bull. Amer.
///             Meteor. Soc. 57 (1976) 1217, for x >= 1: sum over n of e^-nx (x^3/n + 3x^2/n^2 + 6x/n^3 +
///             6/n^4); below, powers of x; Gauss-Legendre where a difference of two values would lose digits.
///   accuracy  1e-12 relative
PlanckIntegral planck_integral(double from, double to);

/// The integrals with the integrand multiplied by weight(x), by 4-point Gauss-Legendre on pieces of x no
/// wider than 0.5.
///   accuracy  1e-11 relative for a weight that is linear in wavelength
template <class Weight>
PlanckIntegral planck_quadrature(double from, double to, const Weight& weight) {
    constexpr std::array<double, 4> nodes = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                                             0.86113631159405258};
    constexpr std::array<double, 4> shares = {0.34785484513745386, 0.65214515486254614, 0.65214515486254614,
                                              0.34785484513745386};
    constexpr double widest_piece = 0.5;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / widest_piece)));
    const double half = 0.5 * (to - from) / pieces;
    PlanckIntegral sum;
    for (int piece = 0; piece < pieces; ++piece) {
        const double middle = from + (2 * piece + 1) * half;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double x = middle + half * nodes[i];
            const PlanckIntegral value = planck_integrand(x);
            const double share = shares[i] * weight(x);
            sum.energy += share * value.energy;
            sum.slope += share * value.slope;
        }
    }
    return {half * sum.energy, half * sum.slope};
}

}  // namespace infra
