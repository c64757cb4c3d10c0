#include "rt/materials/scattering.h"

#include <cmath>
#include <numbers>

namespace infra {

double fresnel_approximation(double c) { return std::exp(-5.85 * c) - 0.00287989916; }

void Scattering::eval(const Vec3& wi, double omega, Spectrum& result) const {
    result.clear();
    const double cosine = dot(normal, wi);
    const Spectrum& lambertian = cosine >= 0 ? diffuse : diffuse_through;
    double scale = std::fabs(cosine) * std::numbers::inv_pi;
    if (fresnel_coupled) scale *= 1.0 - fresnel_approximation(std::fabs(cosine));
    result.add_scaled(lambertian, static_cast<float>(scale));
    for (int i = 0; i < lobe_count; ++i)
        result.add_scaled(lobes[i]->coefficient, static_cast<float>(lobes[i]->eval(wi, omega)));
}

}  // namespace infra
