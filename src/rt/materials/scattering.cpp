#include "rt/materials/scattering.h"

#include <cmath>
#include <numbers>

namespace infra {

double fresnel_approximation(double c, double offset) { return std::exp(-5.85 * c) - offset; }

double schlick_share(double c) {
    const double missing = 1.0 - c, squared = missing * missing;
    return squared * squared * missing;
}

void Scattering::smooth_albedo(Spectrum& result) const {
    result.clear();
    if (has_mirror) result += mirror_coefficient;
    if (has_through) result.add_scaled(through_coefficient, 1.0f / radiance_change);
    if (pure_specular) return;
    result += ambient;
    result += ambient_through;
}

void Scattering::eval(const Vec3& wi, double omega, bool with_lobes, Spectrum& result) const {
    result.clear();
    const double cosine = dot(normal, wi), cosine_through = dot(through_normal, wi);
    double coat = 1;
    if (fresnel_coupled) coat -= fresnel_approximation(std::fabs(dot(fresnel_normal, wi)), fresnel_offset);
    if (schlick_coupled) coat -= schlick_share(std::fabs(cosine));
    if (cosine >= 0) result.add_scaled(diffuse, static_cast<float>(cosine * std::numbers::inv_pi * coat));
    if (cosine_through < 0)
        result.add_scaled(diffuse_through, static_cast<float>(-cosine_through * std::numbers::inv_pi * coat));
    if (!with_lobes) return;
    if (response) response->add(wi, omega, result);
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
