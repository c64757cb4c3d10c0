#include "rt/materials/scattering.h"

#include <cmath>
#include <numbers>

namespace infra {

double fresnel_approximation(double c) { return std::exp(-5.85 * c) - 0.00287989916; }

void Scattering::smooth_albedo(Spectrum& result) const {
    result.clear();
    if (has_mirror) result += mirror_coefficient;
    if (has_through) result += through_coefficient;
    if (pure_specular) return;
    result += ambient;
    result += ambient_through;
}

void Scattering::eval(const Vec3& wi, double omega, Spectrum& result) const {
    result.clear();
    const double cosine = dot(normal, wi);
    const Spectrum& lambertian = cosine >= 0 ? diffuse : diffuse_through;
    double scale = std::fabs(cosine) * std::numbers::inv_pi;
    if (fresnel_coupled) scale *= 1.0 - fresnel_approximation(std::fabs(cosine));
    result.add_scaled(lambertian, static_cast<float>(scale));
    for (int i = 0; i < lobe_count; ++i) {
        const Lobe& lobe = *lobes[i];
        const auto value = static_cast<float>(lobe.eval(wi, omega));
        if (lobe.colored && value > 0) [[unlikely]] {
            Spectrum tint(result.channels());
            lobe.tint(wi, tint);
            result.add_scaled(lobe.coefficient * tint, value);
        } else {
            result.add_scaled(lobe.coefficient, value);
        }
    }
}

}  // namespace infra
