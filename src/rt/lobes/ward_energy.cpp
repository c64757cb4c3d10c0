#include "rt/lobes/ward_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/lobes/ward.h"

namespace infra {
namespace {

constexpr int angles = 64, azimuths = 16;  // intervals, each from 0 to 90 deg
constexpr int slope_sizes = 160, slope_turns = 160;
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

/// Where a value 0 .. half_pi lies among nodes `intervals` + 1 in number.
struct Place {
    std::size_t cell;
    double t;

    Place(double value, int intervals) {
        const double place = std::clamp(value, 0.0, half_pi) * (intervals / half_pi);
        cell = static_cast<std::size_t>(std::min(static_cast<int>(place), intervals - 1));
        t = place - static_cast<double>(cell);
    }
};

}  // namespace

WardEnergy::Node WardEnergy::at_angles(double angle, double azimuth) const {
    const Vec3 normal{0, 0, 1};
    const Vec3 view{-std::sin(angle) * std::cos(azimuth), -std::sin(angle) * std::sin(azimuth),
                    -std::cos(angle)};
    double accepted = 0, weight = 0;
    for (int i = 0; i < slope_sizes; ++i) {
        const double size = std::sqrt(-std::log((i + 0.5) / slope_sizes));
        for (int k = 0; k < slope_turns; ++k) {
            const double turn = 2 * std::numbers::pi * (k + 0.5) / slope_turns;
            const Vec3 half{roughness_.u * size * std::cos(turn), roughness_.v * size * std::sin(turn), 1};
            const double w = ward_weight(view, ward_reflected(view, half), normal);
            accepted += w > 0;
            weight += w;
        }
    }
    return {accepted / (slope_sizes * slope_turns), accepted > 0 ? weight / accepted : 0.0};
}

void WardEnergy::make_nodes() const {
    constexpr double nearly_grazing = 1.5707;
    const int last = roughness_.isotropic() ? 0 : azimuths;
    for (int k = 0; k <= last; ++k)
        for (int i = 0; i <= angles; ++i)
            nodes_.push_back(
                at_angles(std::min(i * half_pi / angles, nearly_grazing), k * half_pi / azimuths));
}

WardEnergy::Node WardEnergy::between(double angle, double azimuth) const {
    const Place along(angle, angles), around(azimuth, azimuths);
    const auto row = [&](std::size_t k) {
        const Node *a = &nodes_[k * (angles + 1) + along.cell], *b = a + 1;
        return Node{a->accepted + along.t * (b->accepted - a->accepted),
                    a->weight + along.t * (b->weight - a->weight)};
    };
    if (roughness_.isotropic()) return row(0);
    const Node a = row(around.cell), b = row(around.cell + 1);
    return {a.accepted + around.t * (b.accepted - a.accepted), a.weight + around.t * (b.weight - a.weight)};
}

double WardEnergy::mean_weight(const Vec3& to_viewer, int count) const {
    std::call_once(made_, [this] { make_nodes(); });
    const double azimuth = std::atan2(std::fabs(to_viewer.y), std::fabs(to_viewer.x));
    const Node node = between(std::acos(std::clamp(to_viewer.z, 0.0, 1.0)), azimuth);
    return node.accepted > 0 ? node.weight * mean_of_accepted_share(node.accepted, count) : 0.0;
}

}  // namespace infra
