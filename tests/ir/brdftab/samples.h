// Synthetic measurements in the layouts of real ones.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "ir/brdftab/sample.h"
#include "nrlbrdf/models.h"

namespace infra::ir::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180;

/// A goniometer's cuts: theta_r 0..80 deg every `step`, phi 0, 90 and 180 deg.
inline std::vector<BrdfSample> measure_cuts(const BrdfFunction& f, const std::vector<int>& incident_deg,
                                            int step_deg) {
    std::vector<BrdfSample> samples;
    for (const int i : incident_deg)
        for (int r = 0; r <= 80; r += step_deg)
            for (int phi = 0; phi <= 180; phi += 90)
                samples.push_back(
                    {i * degree, phi * degree, r * degree, f(i * degree, phi * degree, r * degree), 0});
    return samples;
}

/// Ward's lobe as published (SIGGRAPH 1992, eq. 5a), with 1/sqrt(cos cos): no function of the half vector
/// alone, so that interpolating by half vectors is put to a test.
inline BrdfFunction ward_in_full(double diffuse, double specular, double alpha) {
    return [=, bounded = gaussian_lobe(0, specular, alpha)](double theta_i, double phi, double theta_r) {
        return diffuse / pi +
               bounded(theta_i, phi, theta_r) / std::sqrt(std::cos(theta_i) * std::cos(theta_r));
    };
}

}  // namespace infra::ir::test
