#include "nrlbrdf/coating_models.h"

#include <cmath>
#include <numbers>

#include "nrlbrdf/fresnel.h"
#include "nrlbrdf/half_vector.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

double square(double x) { return x * x; }

}  // namespace

double SandfordRobertson::falloff(double theta) const {
    // Written so that it is 0, not 0/0 or 1/inf, at 90 deg.
    const double cos2 = square(std::cos(theta));
    return cos2 / (cos2 + square(grazing) * (1 - cos2));
}

double SandfordRobertson::falloff_mean() const {
    const double b2 = square(grazing);
    return (1 + b2 / (1 - b2) * std::log(b2)) / (1 - b2);
}

double SandfordRobertson::lobe_integral(double theta_i) const {
    const double e2 = square(width);
    const double c = (1 - e2) * std::cos(theta_i);
    return (c + (2 * e2 + c * c) / std::sqrt(c * c + 4 * e2)) / (2 * e2);
}

BrdfFunction sandford_robertson(const SandfordRobertson& model) {
    return [model, mean = model.falloff_mean()](double theta_i, double phi, double theta_r) {
        const double gi = model.falloff(theta_i) / mean, gr = model.falloff(theta_r) / mean;
        const double cos2_h = square(std::cos(half_vector(theta_i, phi, theta_r).theta_h));
        const double lobe = 1 / square(square(model.width) * cos2_h + 1 - cos2_h);
        const double specular = 1 - (model.emissivity + model.diffuse) * gi;
        return model.diffuse * gi * gr / pi +
               specular * lobe / (4 * pi * model.lobe_integral(theta_i) * std::cos(theta_r));
    };
}

BrdfFunction beard_maxwell(const BeardMaxwell& model) {
    return [model](double theta_i, double phi, double theta_r) {
        const HalfVector half = half_vector(theta_i, phi, theta_r);
        const double cos_i = std::cos(theta_i), cos_r = std::cos(theta_r), cos_h = std::cos(half.theta_h);
        // The zero-bistatic lobe without its Fresnel factor, which R(theta_d) replaces.
        const double first_surface =
            model.bias / (4 * cos_h * (square(model.sigma) + square(std::tan(half.theta_h))));
        const double tilt = half.theta_h / model.omega;
        const double shadowing = (1 + tilt * std::exp(-2 * half.theta_d / model.tau)) / (1 + tilt);
        return fresnel_reflectance(std::cos(half.theta_d), model.n, model.k) * first_surface * square(cos_h) /
                   (cos_i * cos_r) * shadowing +
               model.diffuse / pi + 2 * model.volume / (cos_i + cos_r);
    };
}

BrdfFunction ggx(double diffuse, double alpha, double n, double k) {
    return [=, a2 = alpha * alpha](double theta_i, double phi, double theta_r) {
        const HalfVector half = half_vector(theta_i, phi, theta_r);
        const double cos_i = std::cos(theta_i), cos_r = std::cos(theta_r);
        const double cos2_h = square(std::cos(half.theta_h));
        const double facets = a2 / (pi * square(cos2_h * a2 + 1 - cos2_h));
        // Masking and shadowing over 4 cos cos, in the form that has no 0/0.
        const double visible = 0.5 / (cos_i * std::sqrt(a2 + (1 - a2) * square(cos_r)) +
                                      cos_r * std::sqrt(a2 + (1 - a2) * square(cos_i)));
        return diffuse / pi + fresnel_reflectance(std::cos(half.theta_d), n, k) * facets * visible;
    };
}

}  // namespace infra
