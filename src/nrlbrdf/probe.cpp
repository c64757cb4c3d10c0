#include "nrlbrdf/probe.h"

#include <numbers>

namespace infra {

Vec3 sample_probe(const Vec3& wo, double alpha, double u1, double u2) {
    const double slope = alpha * std::sqrt(-std::log1p(-u1));
    const double azimuth = 2 * std::numbers::pi * u2;
    const Vec3 half = normalize(Vec3{slope * std::cos(azimuth), slope * std::sin(azimuth), 1});
    return normalize(2 * dot(wo, half) * half - wo);
}

double probe_pdf(const Vec3& wo, const Vec3& wi, double alpha) {
    if (wo.z <= 0 || wi.z <= 0) return 0;
    const Vec3 half = normalize(wo + wi);
    const double slope2 = (half.x * half.x + half.y * half.y) / (half.z * half.z);
    const double density_of_slope = std::exp(-slope2 / (alpha * alpha)) / (std::numbers::pi * alpha * alpha);
    // cos^3 turns slopes into solid angle around the half vector, 4 wo.h that into solid angle of wi.
    return density_of_slope / (half.z * half.z * half.z * 4 * dot(wo, half));
}

}  // namespace infra
