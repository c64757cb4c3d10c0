// From radiance back to temperature, for any law that grows with temperature. Only for planck*.cpp.
#pragma once

#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "common/planck/planck.h"

namespace infra {

/// Solves law(T).radiance = radiance by Newton's method between brackets.
///   law    temperature in kelvin -> ThermalRadiance; a black body's in any band or through any response
///   guess  kelvin, to start from
/// With a black body's law ln L is a falling and convex function of 1/T (it is at each wavelength, and sums
/// keep that), so that from the hot side Newton's steps in 1/T never pass the root. Where the radiance is too
/// small for a double a step by bisection is taken instead.
template <class Law>
double invert_radiance(const Law& law, double radiance, double guess = 300.0) {
    if (!(radiance > 0.0) || std::isinf(radiance))
        throw Error(formatted("radiance %g has no temperature", radiance), "it must be a positive number");
    constexpr double enough = 1e-13;
    constexpr int most_steps = 300;
    double hot = 1.0 / hottest_temperature, cold = 1.0 / coldest_temperature;  // of 1/T
    double inverse = 1.0 / guess;
    for (int step = 0; step < most_steps; ++step) {
        const ThermalRadiance at = law(1.0 / inverse);
        (at.radiance >= radiance ? hot : cold) = inverse;
        const double excess = std::log(at.radiance / radiance);
        const double change = excess * at.radiance * inverse * inverse / at.slope;
        const bool usable = std::isfinite(change);
        if (usable && std::abs(change) <= enough * inverse) break;
        const double next = inverse + change;
        inverse = usable && next > hot && next < cold ? next : std::sqrt(hot * cold);
        if (cold - hot <= enough * hot) break;
    }
    const double temperature = 1.0 / inverse;
    constexpr double margin = 1e-9;
    if (temperature < coldest_temperature * (1 + margin) || temperature > hottest_temperature * (1 - margin))
        throw Error(formatted("no temperature from %g to %g K has the radiance %g", coldest_temperature,
                              hottest_temperature, radiance),
                    "is it in W.m-2.sr-1 over the band?");
    return temperature;
}

}  // namespace infra
