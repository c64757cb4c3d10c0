// The tables that the tests of this folder share: three of different shape, each with a Lambertian part and a
// lobe.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "nrlbrdf/models.h"
#include "nrlbrdf/table.h"

namespace infra::test {

using NamedTable = std::pair<std::string, std::shared_ptr<const BrdfTable>>;

inline std::vector<NamedTable> three_tables() {
    const auto make = [](const BrdfFunction& f, const GridCounts& counts) {
        return std::make_shared<const BrdfTable>(tabulate(f, counts));
    };
    // The last is no model of anything: lopsided in phi, with zeros, and zero all over for the normal viewer.
    const BrdfFunction lopsided = [](double theta_i, double phi, double theta_r) {
        const double ripple = std::sin(phi - 1) + 0.4 * std::sin(5 * phi) + 0.2 * std::cos(3 * theta_i);
        return ripple > 0 ? 0.3 * ripple * std::sin(theta_r) : 0;
    };
    return {{"gaussian", make(gaussian_lobe(0.2, 0.5, 0.25), {46, 72, 46})},
            {"phong", make(phong_lobe(0.3, 0.4, 8), {20, 20, 40})},
            {"lopsided", make(lopsided, {7, 31, 5})}};
}

inline Vec3 direction(double theta, double azimuth) {
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

}  // namespace infra::test
