#pragma once

#include <cmath>

namespace infra {

/// Real roots of a t^2 + 2 half_b t + c in ascending order; returns their number, a double root counting
/// once.
inline int solve_quadratic(double a, double half_b, double c, double roots[2]) {
    constexpr double tiny = 1e-6;
    if (std::fabs(a) <= tiny * tiny) {
        if (std::fabs(half_b) <= tiny * tiny) return 0;
        roots[0] = -0.5 * c / half_b;
        return 1;
    }
    const double discriminant = half_b * half_b - a * c;
    if (discriminant < 0) return 0;
    if (discriminant == 0) {
        roots[0] = -half_b / a;
        return 1;
    }
    // The root without cancellation first, the other from the product of the roots.
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    const double first = q / a;
    const double second = c / q;
    roots[0] = first < second ? first : second;
    roots[1] = first < second ? second : first;
    return 2;
}

}  // namespace infra
