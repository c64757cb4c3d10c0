#include "common/planck/planck_integral.h"

#include <numbers>

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double whole = pi * pi * pi * pi / 15.0;

/// Where the two series change over: both converge fast there.
constexpr double series_change = 1.0;

/// Integral of x^3/(e^x - 1) from x to infinity, x >= series_change.
double tail_integral(double x) {
    if (x > 745.0) return 0.0;
    const double ratio = std::exp(-x);
    double power = 1.0, sum = 0.0;
    for (int n = 1; n <= 50; ++n) {
        power *= ratio;
        const double inverse = 1.0 / n;
        const double term =
            power * inverse *
            (((x + 3.0 * inverse) * x + 6.0 * inverse * inverse) * x + 6.0 * inverse * inverse * inverse);
        sum += term;
        if (term < 1e-17 * sum) break;
    }
    return sum;
}

/// Integral of x^3/(e^x - 1) from 0 to x < series_change: x^2 (1 - x/2 + sum B_2k x^2k / (2k)!) term by term.
double head_integral(double x) {
    constexpr std::array<double, 8> coefficients = {1.0 / 12,          -1.0 / 720,
                                                    1.0 / 30240,       -1.0 / 1209600,
                                                    1.0 / 47900160,    -691.0 / 1307674368000,
                                                    1.0 / 74724249600, -3617.0 / 10670622842880000};
    double sum = 1.0 / 3.0 - x / 8.0;
    double power = x * x;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        sum += coefficients[k] * power / (2.0 * double(k) + 5.0);
        power *= x * x;
    }
    return x * x * x * sum;
}

double energy_integral(double from, double to) {
    if (from >= series_change) return tail_integral(from) - tail_integral(to);
    if (to < series_change) return head_integral(to) - head_integral(from);
    return whole - head_integral(from) - tail_integral(to);
}

/// x times the energy integrand, 0 at both ends of the scale.
double edge(double x) { return std::isfinite(x) ? x * planck_integrand(x).energy : 0.0; }

}  // namespace

PlanckIntegral planck_integral(double from, double to) {
    constexpr double narrow = 0.5;
    if (to - from < narrow) return planck_quadrature(from, to, [](double) { return 1.0; });
    const double energy = energy_integral(from, to);
    return {energy, 4.0 * energy + edge(from) - edge(to)};  // by parts
}

}  // namespace infra
