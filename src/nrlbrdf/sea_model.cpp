#include "nrlbrdf/sea_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nrlbrdf/fresnel.h"
#include "nrlbrdf/half_vector.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

/// Slopes beyond this many standard deviations (of the total slope) are left out: exp(-36) of the facets.
constexpr double slope_reach = 6;
constexpr int slope_steps = 400;  // even, for Simpson's rule

/// Smith's Lambda of Gaussian slopes times cos(theta), finite at 90 deg.
double masked_share(double cos_theta, double sigma) {
    const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
    if (sin_theta == 0) return 0;
    const double nu = cos_theta / (sin_theta * sigma);
    return (sigma * sin_theta * std::exp(-nu * nu) / std::sqrt(pi) - cos_theta * std::erfc(nu)) / 2;
}

double simpson_weight(int n) { return n == 0 || n == slope_steps ? 1 : n % 2 == 1 ? 4 : 2; }

}  // namespace

BrdfFunction cox_munk(const Sea& sea) {
    return [sea, variance = sea.slope_variance()](double theta_i, double phi, double theta_r) {
        const HalfVector half = half_vector(theta_i, phi, theta_r);
        const double cos_i = std::cos(theta_i), cos_r = std::cos(theta_r), cos_h = std::cos(half.theta_h);
        const double slope = std::tan(half.theta_h);
        const double density = std::exp(-slope * slope / variance) / (pi * variance);
        const double sigma = std::sqrt(variance);
        // cos_i cos_r (1 + Lambda_i + Lambda_r)
        const double seen =
            cos_i * cos_r + masked_share(cos_i, sigma) * cos_r + masked_share(cos_r, sigma) * cos_i;
        return fresnel_reflectance(std::cos(half.theta_d), sea.n, sea.k) * density /
               (4 * seen * std::pow(cos_h, 4));
    };
}

double sea_emissivity(const Sea& sea, double theta) {
    const double sigma = std::sqrt(sea.slope_variance());
    const double sin_theta = std::sin(theta), cos_theta = std::max(0.0, std::cos(theta));
    // Facets with slope x towards the viewer are seen while cos(chi)/cos(beta) = cos - x sin > 0.
    const double reach = slope_reach * sigma;
    const double visible = sin_theta > 0 ? std::min(reach, cos_theta / sin_theta) : reach;
    const double x_step = (visible + reach) / slope_steps, y_step = reach / slope_steps;
    double emitted = 0, seen = 0;
    for (int a = 0; a <= slope_steps; ++a) {
        const double x = -reach + a * x_step;
        const double area = std::max(0.0, cos_theta - x * sin_theta);
        for (int b = 0; b <= slope_steps; ++b) {
            const double y = b * y_step;
            const double weight =
                simpson_weight(a) * simpson_weight(b) * area * std::exp(-(x * x + y * y) / (sigma * sigma));
            const double cos_chi = std::min(1.0, area / std::sqrt(1 + x * x + y * y));
            emitted += weight * (1 - fresnel_reflectance(cos_chi, sea.n, sea.k));
            seen += weight;
        }
    }
    return emitted / seen;
}

}  // namespace infra
