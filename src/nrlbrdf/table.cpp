#include "nrlbrdf/table.h"

#include <algorithm>
#include <numbers>

#include "common/error.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half_pi = pi / 2;

/// Azimuth of wo minus that of wi. A viewer at the pole is given azimuth 0, so that phi still varies with wi
/// and hemispherical integrals hold there too.
double relative_azimuth(const Vec3& wo, const Vec3& wi) {
    const bool at_pole = wo.x == 0 && wo.y == 0;
    const double ox = at_pole ? 1 : wo.x;
    return std::atan2(wi.x * wo.y - wi.y * ox, wi.x * ox + wi.y * wo.y);
}

}  // namespace

double polar_angle(const Vec3& direction) {
    return std::atan2(std::sqrt(direction.x * direction.x + direction.y * direction.y), direction.z);
}

GridPlace polar_place(double theta, int count) {
    const double position = std::clamp(theta / half_pi, 0.0, 1.0) * (count - 1);
    const int cell = std::min(static_cast<int>(position), count - 2);
    return {cell, position - cell};
}

std::vector<double> polar_weights(int count) {
    // With cos sin = sin(2 theta)/2, whose first and second antiderivatives are -cos(2 theta)/4 and -sin(2
    // theta)/8, a hat's integral is a second difference of the latter. The cosine's terms are the ends'
    // one-sided slopes.
    const double step = half_pi / (count - 1);
    const auto second = [&](int i) { return -std::sin(2 * step * i) / 8; };
    std::vector<double> weights(static_cast<std::size_t>(count));
    for (int i = 1; i + 1 < count; ++i)
        weights[static_cast<std::size_t>(i)] = (second(i - 1) - 2 * second(i) + second(i + 1)) / step;
    weights.front() = 0.25 + (second(1) - second(0)) / step;
    weights.back() = 0.25 + (second(count - 2) - second(count - 1)) / step;
    return weights;
}

BrdfTable::BrdfTable(const BrdfGrid& grid)
    : theta_i_count_(grid.theta_i_count),
      phi_count_(grid.phi_count),
      theta_r_count_(grid.theta_r_count),
      phi_origin_(grid.phi_origin),
      values_(grid.values.size()) {
    if (theta_i_count_ < 2 || phi_count_ < 2 || theta_r_count_ < 2 ||
        values_.size() != static_cast<std::size_t>(theta_i_count_) * static_cast<std::size_t>(phi_count_) *
                              static_cast<std::size_t>(theta_r_count_))
        throw Error("BRDF grid: counts and number of values disagree", {}, Severity::internal);

    auto value = grid.values.begin();
    for (int i = 0; i < theta_i_count_; ++i)
        for (int k = 0; k < phi_count_; ++k)
            for (int j = 0; j < theta_r_count_; ++j) values_[index(i, k, j)] = *value++;

    const auto [smallest, largest] = std::minmax_element(values_.begin(), values_.end());
    smallest_ = *smallest;
    diffuse_ = pi * smallest_;
    lobe_is_zero_ = *smallest == *largest;

    const double phi_step = 2 * pi / phi_count_;
    const std::vector<double> weights = polar_weights(theta_i_count_);
    lobe_reflectance_.resize(static_cast<std::size_t>(theta_r_count_));
    for (int j = 0; j < theta_r_count_; ++j) {
        double total = 0;
        for (int i = 0; i < theta_i_count_; ++i) {
            double row = 0;
            for (int k = 0; k < phi_count_; ++k) row += lobe_node(i, k, j);
            total += row * weights[static_cast<std::size_t>(i)];
        }
        lobe_reflectance_[static_cast<std::size_t>(j)] = total * phi_step;
    }
}

double BrdfTable::eval_lobe(double theta_i, double phi, double theta_r) const {
    const GridPlace i = polar_place(theta_i, theta_i_count_);
    const GridPlace j = polar_place(theta_r, theta_r_count_);
    const double turns = (phi - phi_origin_) / (2 * pi);
    const double position = (turns - std::floor(turns)) * phi_count_;
    const int k0 = static_cast<int>(position) % phi_count_;  // position may round up to phi_count
    const int k1 = k0 + 1 == phi_count_ ? 0 : k0 + 1;
    const double k_fraction = position - std::floor(position);

    const auto row = [&](int i_node, int j_node) {
        const std::size_t start = index(i_node, 0, j_node);
        return (1 - k_fraction) * lobe_at(start + static_cast<std::size_t>(k0)) +
               k_fraction * lobe_at(start + static_cast<std::size_t>(k1));
    };
    const auto column = [&](int j_node) {
        return (1 - i.fraction) * row(i.cell, j_node) + i.fraction * row(i.cell + 1, j_node);
    };
    return (1 - j.fraction) * column(j.cell) + j.fraction * column(j.cell + 1);
}

double BrdfTable::eval_lobe(const Vec3& wo, const Vec3& wi) const {
    if (lobe_is_zero_ || wo.z < 0 || wi.z < 0) return 0;
    return eval_lobe(polar_angle(wi), relative_azimuth(wo, wi), polar_angle(wo));
}

double BrdfTable::eval(const Vec3& wo, const Vec3& wi) const {
    return wo.z < 0 || wi.z < 0 ? 0 : smallest_ + eval_lobe(wo, wi);
}

double BrdfTable::lobe_reflectance_dh(double cos_theta_o) const {
    if (lobe_is_zero_) return 0;
    const GridPlace j = polar_place(std::acos(std::clamp(cos_theta_o, 0.0, 1.0)), theta_r_count_);
    return (1 - j.fraction) * lobe_reflectance_node(j.cell) + j.fraction * lobe_reflectance_node(j.cell + 1);
}

double BrdfTable::reflectance_dh(double cos_theta_o) const {
    return diffuse_ + lobe_reflectance_dh(cos_theta_o);
}

double BrdfTable::incident_reflectance(int i) const {
    const std::vector<double> weights = polar_weights(theta_r_count_);
    double total = 0;
    for (int j = 0; j < theta_r_count_; ++j) {
        double row = 0;
        for (int k = 0; k < phi_count_; ++k) row += lobe_node(i, k, j);
        total += row * weights[static_cast<std::size_t>(j)];
    }
    return diffuse_ + total * (2 * pi / phi_count_);
}

}  // namespace infra
