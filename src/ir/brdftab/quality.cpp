#include "ir/brdftab/quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;

/// Beyond this angle [rad] lobes are narrow in phi and models have no bound.
constexpr double grazing = 60 * pi / 180;

/// Values below this share of the RMS don't count for the largest ratio.
constexpr double significant = 0.01;

/// Calls visit(f, g, theta_i, phi, theta_r) for all pairs of values to compare.
using Visit = std::function<void(double f, double g, double theta_i, double phi, double theta_r)>;
using ForEachPair = std::function<void(const Visit&)>;

Difference compare(const ForEachPair& for_each) {
    double squares = 0, differences = 0, weights = 0, peak = 0, largest = 0;
    for_each([&](double f, double g, double theta_i, double, double theta_r) {
        const double weight = std::sin(2 * theta_i) * std::sin(2 * theta_r);
        squares += weight * (f * f + g * g) / 2;
        differences += weight * (f - g) * (f - g);
        weights += weight;
        if (theta_i <= grazing && theta_r <= grazing) {
            peak = std::max({peak, f, g});
            largest = std::max(largest, std::abs(f - g));
        }
    });
    if (squares == 0) return {};
    Difference result{.rms = std::sqrt(differences / squares), .of_peak = peak > 0 ? largest / peak : 0};
    const double least = significant * std::sqrt(squares / weights);
    for_each([&](double f, double g, double theta_i, double phi, double theta_r) {
        const double mean = (f + g) / 2, ratio = std::abs(f - g) / mean;
        if (mean > least && ratio > result.largest)
            result = {result.rms, result.of_peak, ratio, theta_i, phi, theta_r};
    });
    return result;
}

/// Directional-hemispherical reflectance of a function with f(phi) = f(-phi) towards theta_r: two points of
/// Gauss for each degree of theta_i, the midpoint rule in phi.
double source_reflectance(const BrdfFunction& f, double theta_r) {
    constexpr int polar_cells = 90, azimuth_steps = 360;
    constexpr double cell = pi / 2 / polar_cells, azimuth_step = pi / azimuth_steps;
    const double offset = 0.5 / std::sqrt(3.0);
    double total = 0;
    for (int i = 0; i < polar_cells; ++i)
        for (const double place : {0.5 - offset, 0.5 + offset}) {
            const double theta = (i + place) * cell;
            double row = 0;
            for (int k = 0; k < azimuth_steps; ++k) row += f(theta, (k + 0.5) * azimuth_step, theta_r);
            total += row * std::sin(2 * theta) / 2;
        }
    return total * cell / 2 * 2 * azimuth_step;
}

}  // namespace

double table_value(const BrdfTable& table, double theta_i, double phi, double theta_r) {
    return table.diffuse_reflectance() / pi + table.eval_lobe(theta_i, phi, theta_r);
}

Difference reciprocity_error(const BrdfTable& table) {
    return compare([&](const Visit& visit) {
        for (int i = 0; i < table.theta_i_count(); ++i)
            for (int k = 0; k < table.phi_count(); ++k)
                for (int j = 0; j < table.theta_r_count(); ++j) {
                    const double theta_i = pi / 2 * i / (table.theta_i_count() - 1);
                    const double phi = table.phi_origin() + 2 * pi * k / table.phi_count();
                    const double theta_r = pi / 2 * j / (table.theta_r_count() - 1);
                    visit(table_value(table, theta_i, phi, theta_r),
                          table_value(table, theta_r, phi, theta_i), theta_i, phi, theta_r);
                }
    });
}

Difference interpolation_error(const BrdfTable& table, const BrdfFunction& source) {
    return compare([&](const Visit& visit) {
        for (int i = 0; i + 2 < table.theta_i_count(); ++i)
            for (int k = 0; k < table.phi_count(); ++k)
                for (int j = 0; j + 2 < table.theta_r_count(); ++j) {
                    const double theta_i = pi / 2 * (i + 0.5) / (table.theta_i_count() - 1);
                    const double phi = table.phi_origin() + 2 * pi * (k + 0.5) / table.phi_count();
                    const double theta_r = pi / 2 * (j + 0.5) / (table.theta_r_count() - 1);
                    visit(table_value(table, theta_i, phi, theta_r), source(theta_i, phi, theta_r), theta_i,
                          phi, theta_r);
                }
    });
}

ReflectanceError reflectance_error(const BrdfTable& table, const BrdfFunction& source) {
    const double cell = pi / 2 / (table.theta_r_count() - 1);
    ReflectanceError error;
    for (int degrees = 0; degrees <= 80; degrees += 20) {
        const double node = std::round(degrees * pi / 180 / cell) * cell;
        for (const double theta_r : {node, node + cell / 2}) {
            if (theta_r > pi / 2 - cell) continue;  // as in interpolation_error
            const double expected = source_reflectance(source, theta_r);
            const double difference = std::abs(table.reflectance_dh(std::cos(theta_r)) - expected);
            if (difference > error.largest) {
                error.largest = difference;
                error.theta = theta_r;
            }
            if (expected > 0) error.relative = std::max(error.relative, difference / expected);
        }
    }
    return error;
}

double largest_reflectance(const BrdfTable& table) {
    double largest = 0;
    for (int i = 0; i < table.theta_i_count(); ++i)
        largest = std::max(largest, table.incident_reflectance(i));
    for (int j = 0; j < table.theta_r_count(); ++j)
        largest = std::max(largest, table.diffuse_reflectance() + table.lobe_reflectance_node(j));
    return largest;
}

}  // namespace infra::ir
