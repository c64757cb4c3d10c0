#include "nrlbrdf/table.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/error.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half_pi = pi / 2;

GridShape shape_of(const BrdfGrid& grid) {
    return {grid.theta_i_count, grid.phi_count, grid.theta_r_count, grid.phi_origin};
}

/// A grid's values in the order of its shape.
std::vector<float> ordered_values(const BrdfGrid& grid) {
    const GridShape shape = shape_of(grid);
    if (shape.theta_i_count < 2 || shape.phi_count < 2 || shape.theta_r_count < 2 ||
        grid.values.size() != shape.size())
        throw Error("BRDF grid: counts and number of values disagree", {}, Severity::internal);
    std::vector<float> values(shape.size());
    auto value = grid.values.begin();
    for (int i = 0; i < shape.theta_i_count; ++i)
        for (int k = 0; k < shape.phi_count; ++k)
            for (int j = 0; j < shape.theta_r_count; ++j) values[shape.index(i, k, j)] = *value++;
    return values;
}

}  // namespace

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
    : BrdfTable(shape_of(grid), ordered_values(grid),
                static_cast<double>(*std::ranges::min_element(grid.values))) {}

BrdfTable::BrdfTable(const GridShape& shape, std::vector<float> values, double constant)
    : shape_(shape),
      constant_(constant),
      diffuse_(pi * constant),
      lobe_is_zero_(static_cast<double>(*std::ranges::max_element(values)) == constant),
      values_(std::move(values)) {
    const auto [ni, np, nt, origin] = shape_;
    const double phi_step = 2 * pi / np;
    const std::vector<double> weights = polar_weights(ni);
    lobe_reflectance_.resize(static_cast<std::size_t>(nt));
    for (int j = 0; j < nt; ++j) {
        double total = 0;
        for (int i = 0; i < ni; ++i) {
            double row = 0;
            for (int k = 0; k < np; ++k) row += lobe_node(i, k, j);
            total += row * weights[static_cast<std::size_t>(i)];
        }
        lobe_reflectance_[static_cast<std::size_t>(j)] = total * phi_step;
    }
}

double BrdfTable::eval_lobe(double theta_i, double phi, double theta_r) const {
    const GridCell c = shape_.cell(theta_i, phi, theta_r);
    const auto row = [&](std::size_t start) {
        return (1 - c.k_fraction) * lobe_at(start + c.k0) + c.k_fraction * lobe_at(start + c.k1);
    };
    const auto column = [&](std::size_t near, std::size_t far) {
        return (1 - c.i_fraction) * row(near) + c.i_fraction * row(far);
    };
    return (1 - c.j_fraction) * column(c.row[0], c.row[1]) + c.j_fraction * column(c.row[2], c.row[3]);
}

double BrdfTable::eval_lobe(const Vec3& wo, const Vec3& wi) const {
    if (lobe_is_zero_ || wo.z < 0 || wi.z < 0) return 0;
    return eval_lobe(polar_angle(wi), relative_azimuth(wo, wi), polar_angle(wo));
}

double BrdfTable::eval(const Vec3& wo, const Vec3& wi) const {
    return wo.z < 0 || wi.z < 0 ? 0 : constant_ + eval_lobe(wo, wi);
}

double BrdfTable::lobe_reflectance_dh(double cos_theta_o) const {
    if (lobe_is_zero_) return 0;
    const GridPlace j = polar_place(std::acos(std::clamp(cos_theta_o, 0.0, 1.0)), theta_r_count());
    return (1 - j.fraction) * lobe_reflectance_node(j.cell) + j.fraction * lobe_reflectance_node(j.cell + 1);
}

double BrdfTable::reflectance_dh(double cos_theta_o) const {
    return diffuse_ + lobe_reflectance_dh(cos_theta_o);
}

double BrdfTable::incident_reflectance(int i) const {
    const std::vector<double> weights = polar_weights(theta_r_count());
    double total = 0;
    for (int j = 0; j < theta_r_count(); ++j) {
        double row = 0;
        for (int k = 0; k < phi_count(); ++k) row += lobe_node(i, k, j);
        total += row * weights[static_cast<std::size_t>(j)];
    }
    return diffuse_ + total * (2 * pi / phi_count());
}

}  // namespace infra
