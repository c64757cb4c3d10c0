// Chi-square test of a direction sampler against its density, for everything that samples: materials, lobes,
// sources.
//
//   chi_square_test(sampler, pdf, options)
//     sampler(u1, u2, u3) -> something with .wi (unit Vec3, z up), .weight and .pdf; lost: weight 0 and pdf 0
//     pdf(wi) -> density [1/sr], without any delta lobe
//
// Counts are compared in cells of (cos theta, phi) with the density integrated over each cell; cells that
// expect fewer than 5 hits are pooled, and lost samples are a cell that expects what the density's integral
// leaves of 1. inspired by Mitsuba 3's chi2.py and nori's chi2test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "common/vec.h"

namespace infra::test {

struct ChiSquareOptions {
    int cos_cells = 10;
    int phi_cells = 20;
    std::int64_t samples = 1'000'000;
    std::uint64_t seed = 1;
    bool full_sphere = false;  ///< cos theta in -1..1, else 0..1: what falls below then counts as lost
    double integral_tolerance = 1e-6;      ///< absolute, per cell
    std::int64_t pdf_check_interval = 16;  ///< every so many samples pdf(wi) is compared with sample.pdf
    double largest_pdf_mismatch = 1e-5;    ///< relative, between sample.pdf and pdf(sample.wi)
};

struct ChiSquareResult {
    double statistic = 0;
    int degrees = 0;
    double p = 1;
    double integral = 0;     ///< of the density over all cells; must be <= 1
    double mean_weight = 0;  ///< with its standard error: compare with the reflectance
    double weight_error = 0;
    double weight_deviation = 0;  ///< standard deviation of one weight over the mean
    std::string fault;            ///< not empty: a broken rule that no p-value excuses
};

/// Each of `tests` runs must reach this p for all of them together to be held at `level`.
inline double sidak_level(double level, int tests) { return 1 - std::pow(1 - level, 1.0 / tests); }

/// Probability that chi-square with `degrees` of freedom exceeds `statistic`: the regularised gamma function
/// Q.
inline double chi_square_p(double statistic, int degrees) {
    const double a = degrees / 2.0, x = statistic / 2;
    if (!(x > 0)) return 1;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1) {  // series of P
        double term = 1 / a, sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-16; ++n) sum += term *= x / (a + n);
        return 1 - front * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;  // Lentz's continued fraction of Q
    for (int n = 1; n < 10000; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return front * fraction;
}

/// Integral of g(x, y) over a rectangle: 3 x 3 Gauss points, halved until two levels agree to `tolerance`,
/// but at least twice so that a narrow peak is not missed.
template <class Function>
double integrate_cell(const Function& g, double x0, double x1, double y0, double y1, double tolerance,
                      int depth = 0) {
    constexpr std::array<double, 3> nodes = {-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const auto gauss = [&](double a, double b, double c, double d) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                sum += weights[i] * weights[j] *
                       g((a + b + (b - a) * nodes[i]) / 2, (c + d + (d - c) * nodes[j]) / 2);
        return sum * (b - a) * (d - c);
    };
    const double xm = (x0 + x1) / 2, ym = (y0 + y1) / 2;
    const double coarse = gauss(x0, x1, y0, y1);
    const double fine =
        gauss(x0, xm, y0, ym) + gauss(xm, x1, y0, ym) + gauss(x0, xm, ym, y1) + gauss(xm, x1, ym, y1);
    if (depth >= 12 || (depth >= 2 && std::abs(fine - coarse) < tolerance)) return fine;
    const auto quarter = [&](double a, double b, double c, double d) {
        return integrate_cell(g, a, b, c, d, tolerance / 2, depth + 1);
    };
    return quarter(x0, xm, y0, ym) + quarter(xm, x1, y0, ym) + quarter(x0, xm, ym, y1) +
           quarter(xm, x1, ym, y1);
}

/// Pools what expects too little, in rising order of expectation, and sums (observed - expected)^2 /
/// expected.
inline void sum_statistic(std::vector<std::array<double, 2>> cells, ChiSquareResult& result) {
    constexpr double least_expected = 5;
    std::sort(cells.begin(), cells.end());  // by expectation, the first element
    double expected = 0, observed = 0;
    int terms = 0;
    for (std::size_t n = 0; n < cells.size(); ++n) {
        expected += cells[n][0];
        observed += cells[n][1];
        const bool last = n + 1 == cells.size();
        if (expected < least_expected && !last) continue;
        if (expected > 0) result.statistic += (observed - expected) * (observed - expected) / expected;
        terms += expected >= least_expected;
        expected = observed = 0;
    }
    result.degrees = std::max(terms - 1, 1);
    result.p = terms > 1 ? chi_square_p(result.statistic, result.degrees) : 1;
}

template <class Sampler, class Pdf>
ChiSquareResult chi_square_test(const Sampler& sampler, const Pdf& pdf,
                                const ChiSquareOptions& options = {}) {
    constexpr double two_pi = 2 * std::numbers::pi;
    const double lowest_cos = options.full_sphere ? -1 : 0;
    const auto cells =
        static_cast<std::size_t>(options.cos_cells) * static_cast<std::size_t>(options.phi_cells);
    std::vector<std::array<double, 2>> counts(cells +
                                              1);  // expected, observed; the last cell is the lost samples
    ChiSquareResult result;

    const auto density = [&](double cos_theta, double phi) {
        const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
        return static_cast<double>(
            pdf(Vec3{sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta}));
    };
    for (std::size_t n = 0; n < cells; ++n) {
        const auto row = static_cast<double>(n / static_cast<std::size_t>(options.phi_cells));
        const auto column = static_cast<double>(n % static_cast<std::size_t>(options.phi_cells));
        const double cos_step = (1 - lowest_cos) / options.cos_cells, phi_step = two_pi / options.phi_cells;
        const double share =
            integrate_cell(density, lowest_cos + row * cos_step, lowest_cos + (row + 1) * cos_step,
                           column * phi_step, (column + 1) * phi_step, options.integral_tolerance);
        result.integral += share;
        counts[n][0] = share * static_cast<double>(options.samples);
    }
    counts[cells][0] = std::max(0.0, 1 - result.integral) * static_cast<double>(options.samples);
    if (result.integral > 1 + 1e-4) result.fault = "density integrates to " + std::to_string(result.integral);

    const auto report = [&](const char* what, const Vec3& wi, double a, double b) {
        std::ostringstream text;
        text << what << " at (" << wi.x << ", " << wi.y << ", " << wi.z << "): " << a << " and " << b;
        if (result.fault.empty()) result.fault = text.str();
    };
    std::mt19937_64 engine(options.seed);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    double sum = 0, sum2 = 0;
    for (std::int64_t n = 0; n < options.samples; ++n) {
        const double u1 = uniform(), u2 = uniform(), u3 = uniform();
        const auto sample = sampler(u1, u2, u3);
        const Vec3 wi = sample.wi;
        const auto weight = static_cast<double>(sample.weight);
        const auto sample_pdf = static_cast<double>(sample.pdf);
        sum += weight;
        sum2 += weight * weight;
        if (!(weight >= 0) || !std::isfinite(weight)) report("bad weight", wi, weight, sample_pdf);
        if (!(sample_pdf > 0)) {
            if (weight > 0) report("weight without density", wi, weight, sample_pdf);
            counts[cells][1] += 1;
            continue;
        }
        if (n % options.pdf_check_interval == 0) {
            const auto value = static_cast<double>(pdf(wi));
            if (!(std::abs(value - sample_pdf) <= options.largest_pdf_mismatch * value))
                report("sample.pdf is not pdf(wi)", wi, sample_pdf, value);
        }
        if (std::abs(dot(wi, wi) - 1) > 1e-6) report("not of unit length", wi, dot(wi, wi), 1);
        if (wi.z < lowest_cos) {
            counts[cells][1] += 1;
            continue;
        }
        const auto cell_of = [](double place, int count) {
            return static_cast<std::size_t>(std::clamp(static_cast<int>(place * count), 0, count - 1));
        };
        const std::size_t row = cell_of((wi.z - lowest_cos) / (1 - lowest_cos), options.cos_cells);
        const double turn = std::atan2(wi.y, wi.x) / two_pi;
        const std::size_t column = cell_of(turn < 0 ? turn + 1 : turn, options.phi_cells);
        counts[row * static_cast<std::size_t>(options.phi_cells) + column][1] += 1;
    }
    for (const auto& [expected, observed] : counts)
        if (expected < 1e-6 && observed > 0 && result.fault.empty())
            result.fault = std::to_string(observed) + " hits in a cell whose density is 0";
    const auto number = static_cast<double>(options.samples);
    result.mean_weight = sum / number;
    const double variance = std::max(0.0, sum2 / number - result.mean_weight * result.mean_weight);
    result.weight_error = std::sqrt(variance / number);
    result.weight_deviation = result.mean_weight > 0 ? std::sqrt(variance) / result.mean_weight : 0;
    sum_statistic(std::move(counts), result);
    return result;
}

}  // namespace infra::test
