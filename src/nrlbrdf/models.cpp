#include "nrlbrdf/models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "common/atomic_file.h"
#include "common/text.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

/// Keeps the half vector's slope defined where both directions graze: the mirror direction still has slope 0.
constexpr double least_z2 = 1e-18;

Vec3 direction(double theta, double azimuth) {
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

}  // namespace

BrdfGrid tabulate(const BrdfFunction& f, const GridCounts& counts) {
    BrdfGrid grid{.theta_i_count = counts.theta_i, .phi_count = counts.phi, .theta_r_count = counts.theta_r};
    grid.values.reserve(static_cast<std::size_t>(counts.theta_i) * static_cast<std::size_t>(counts.phi) *
                        static_cast<std::size_t>(counts.theta_r));
    for (int i = 0; i < counts.theta_i; ++i)
        for (int k = 0; k < counts.phi; ++k)
            for (int j = 0; j < counts.theta_r; ++j)
                grid.values.push_back(
                    static_cast<float>(f(pi / 2 * i / (counts.theta_i - 1), 2 * pi * k / counts.phi,
                                         pi / 2 * j / (counts.theta_r - 1))));
    return grid;
}

BrdfFunction lambertian(double reflectance) {
    return [=](double, double, double) { return reflectance / pi; };
}

BrdfFunction gaussian_lobe(double diffuse, double specular, double alpha) {
    return [=](double theta_i, double phi, double theta_r) {
        const Vec3 sum = direction(theta_i, 0) + direction(theta_r, phi);
        const double tan2 = (sum.x * sum.x + sum.y * sum.y) / std::max(sum.z * sum.z, least_z2);
        return diffuse / pi + specular / (4 * pi * alpha * alpha) * std::exp(-tan2 / (alpha * alpha));
    };
}

BrdfFunction phong_lobe(double diffuse, double specular, double exponent) {
    return [=](double theta_i, double phi, double theta_r) {
        const Vec3 mirrored = direction(theta_r, phi + pi);
        const double cos_gamma = std::max(0.0, dot(direction(theta_i, 0), mirrored));
        return diffuse / pi + specular * (exponent + 2) / (2 * pi) * std::pow(cos_gamma, exponent);
    };
}

void write_table(const std::string& path, const BrdfGrid& grid, std::string_view comment,
                 const std::optional<WavelengthBand>& band) {
    AtomicFile file(path);
    for (std::string_view rest = comment; !rest.empty();) {
        const std::string_view line = take_line(rest);
        std::fprintf(file.stream(), "# %.*s\n", static_cast<int>(line.size()), line.data());
    }
    if (band) std::fprintf(file.stream(), "#%% band %.15g %.15g\n", band->lo_um, band->hi_um);
    if (grid.phi_origin != 0) std::fputs("#% mirror 0\n", file.stream());
    const float smallest = *std::min_element(grid.values.begin(), grid.values.end());
    std::fprintf(file.stream(), "%d %d %d\n%.9g\n", grid.theta_i_count, grid.phi_count, grid.theta_r_count,
                 pi * static_cast<double>(smallest));
    int column = 0;
    for (const float f : grid.values) {
        column = column + 1 == grid.theta_r_count ? 0 : column + 1;
        std::fprintf(file.stream(), "%.9g%c", static_cast<double>(f), column == 0 ? '\n' : ' ');
    }
    file.commit();
}

}  // namespace infra
