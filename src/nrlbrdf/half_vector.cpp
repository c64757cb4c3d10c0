#include "nrlbrdf/half_vector.h"

#include <algorithm>
#include <cmath>

#include "common/vec.h"

namespace infra {
namespace {

/// Keeps h upright where both directions graze and oppose each other.
constexpr double least_z = 1e-9;

}  // namespace

HalfVector half_vector(double theta_i, double phi, double theta_r) {
    const Vec3 wi(std::sin(theta_i), 0, std::cos(theta_i));
    const Vec3 wo(std::sin(theta_r) * std::cos(phi), std::sin(theta_r) * std::sin(phi), std::cos(theta_r));
    Vec3 sum = wi + wo;
    sum.z = std::max(sum.z, least_z);

    HalfVector half;
    const double across = std::hypot(sum.x, sum.y);
    half.theta_h = std::atan2(across, sum.z);
    half.theta_d = std::atan2(length(wi - wo), length(sum));
    half.cos_imbalance = (wo.z - wi.z) / 2;

    // In h's frame the normal lies at azimuth pi: cos theta_i = cos theta_h cos theta_d - scale cos phi_d.
    const double scale = std::sin(half.theta_h) * std::sin(half.theta_d);
    half.phi_d = scale > 1e-12 ? std::acos(std::clamp(half.cos_imbalance / scale, -1.0, 1.0)) : 0;
    return half;
}

}  // namespace infra
