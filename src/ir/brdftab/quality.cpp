#include "ir/brdftab/quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;

/// Values below this share of the RMS don't count for the largest ratio.
constexpr double significant = 0.01;

/// Calls visit(f, g, theta_i, phi, theta_r) for all pairs of values to compare.
using Visit = std::function<void(double f, double g, double theta_i, double phi, double theta_r)>;
using ForEachPair = std::function<void(const Visit&)>;

Difference compare(const ForEachPair& for_each) {
    double squares = 0, differences = 0, weights = 0;
    for_each([&](double f, double g, double theta_i, double, double theta_r) {
        const double weight = std::sin(2 * theta_i) * std::sin(2 * theta_r);
        squares += weight * (f * f + g * g) / 2;
        differences += weight * (f - g) * (f - g);
        weights += weight;
    });
    if (squares == 0) return {};
    Difference result{.rms = std::sqrt(differences / squares)};
    const double least = significant * std::sqrt(squares / weights);
    for_each([&](double f, double g, double theta_i, double phi, double theta_r) {
        const double mean = (f + g) / 2, ratio = std::abs(f - g) / mean;
        if (mean > least && ratio > result.largest) result = {result.rms, ratio, theta_i, phi, theta_r};
    });
    return result;
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

double largest_reflectance(const BrdfTable& table) {
    double largest = 0;
    for (int i = 0; i < table.theta_i_count(); ++i)
        largest = std::max(largest, table.incident_reflectance(i));
    for (int j = 0; j < table.theta_r_count(); ++j)
        largest = std::max(largest, table.diffuse_reflectance() + table.lobe_reflectance_node(j));
    return largest;
}

}  // namespace infra::ir
