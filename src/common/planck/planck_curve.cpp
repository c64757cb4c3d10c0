#include "common/planck/planck_curve.h"

#include <cmath>

#include "common/planck/planck.h"

namespace infra {
namespace {

constexpr double coldest = 20.0, hottest = 6500.0;  // kelvin, what scenes are made of
constexpr int steps = 1024;

}  // namespace

PlanckCurve::PlanckCurve(double lo_um, double hi_um) : lo_um_(lo_um), hi_um_(hi_um) {
    check_band(lo_um, hi_um);
    const double step = std::log(hottest / coldest) / steps;
    nodes_.reserve(steps + 1);
    for (int i = 0; i <= steps; ++i) {
        const double temperature = coldest * std::exp(i * step);
        const ThermalRadiance at = band_thermal_radiance(temperature, lo_um, hi_um);
        nodes_.push_back({std::log(at.radiance), step * temperature * at.slope / at.radiance});
    }
}

double PlanckCurve::radiance(double temperature) const {
    const double position = std::log(temperature / coldest) * (steps / std::log(hottest / coldest));
    if (!(position >= 0 && position < steps)) return band_radiance(temperature, lo_um_, hi_um_);
    const auto cell = static_cast<std::size_t>(position);
    const Node &a = nodes_[cell], &b = nodes_[cell + 1];
    if (!std::isfinite(a.log_radiance)) return band_radiance(temperature, lo_um_, hi_um_);
    const double t = position - static_cast<double>(cell);
    const double difference = b.log_radiance - a.log_radiance;
    const double bend = a.rise - difference + (difference - b.rise - (a.rise - difference)) * t;
    return std::exp(a.log_radiance + t * (difference + (1 - t) * bend));
}

}  // namespace infra
