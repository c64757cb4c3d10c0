#include "rt/lobes/ward_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/lobes/ward.h"

namespace infra {
namespace {

constexpr int angles = 64;
constexpr int slopes = 160, azimuths = 80;  // half the circle: the other half mirrors it
constexpr double half_pi = std::numbers::pi / 2;

/// Mean of count/draws, where draws are made until `count` of them are accepted, each with probability p:
/// the integral over s = 0..1 of (p / (1 - (1-p) s^(1/count)))^count.
double mean_of_accepted_share(double p, int count) {
    const double q = 1 - p, n = count;
    constexpr int few = 32;
    if (count > few) return p * (1 + q / n - q * (1 + q) / (n * n) + 3 * q * q / (n * n));
    constexpr int steps = 64;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += std::pow(p / (1 - q * std::pow((i + 0.5) / steps, 1 / n)), n);
    return sum / steps;
}

}  // namespace

WardEnergy::Node WardEnergy::at_angle(double angle) const {
    const Vec3 normal{0, 0, 1}, view{std::sin(angle), 0, -std::cos(angle)};
    double accepted = 0, weight = 0;
    for (int i = 0; i < slopes; ++i) {
        const double slope = roughness_ * std::sqrt(-std::log((i + 0.5) / slopes));
        for (int k = 0; k < azimuths; ++k) {
            const double azimuth = std::numbers::pi * (k + 0.5) / azimuths;
            const Vec3 half{slope * std::cos(azimuth), slope * std::sin(azimuth), 1};
            const double w = ward_weight(view, ward_reflected(view, half), normal);
            accepted += w > 0;
            weight += w;
        }
    }
    return {accepted / (slopes * azimuths), accepted > 0 ? weight / accepted : 0.0};
}

double WardEnergy::mean_weight(double cosine, int count) const {
    std::call_once(made_, [this] {
        for (int i = 0; i <= angles; ++i) nodes_.push_back(at_angle(std::min(i * half_pi / angles, 1.5707)));
    });
    const double place = std::acos(std::clamp(cosine, 0.0, 1.0)) * (angles / half_pi);
    const auto cell = static_cast<std::size_t>(std::min(static_cast<int>(place), angles - 1));
    const double t = place - static_cast<double>(cell);
    const Node &a = nodes_[cell], &b = nodes_[cell + 1];
    const double accepted = a.accepted + t * (b.accepted - a.accepted);
    const double weight = a.weight + t * (b.weight - a.weight);
    return accepted > 0 ? weight * mean_of_accepted_share(accepted, count) : 0.0;
}

}  // namespace infra
