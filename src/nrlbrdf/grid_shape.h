// The regular grid of angles that a tabulated BRDF stands on, and where a geometry falls in it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "common/vec.h"

namespace infra {

/// A place on a grid of angles: between node `cell` and the next, `fraction` 0..1 of the way.
struct GridPlace {
    int cell;
    double fraction;
};

/// theta in 0..pi/2 on `count` nodes from 0 to 90 deg; cell in 0..count-2.
inline GridPlace polar_place(double theta, int count) {
    const double position = std::clamp(theta / (std::numbers::pi / 2), 0.0, 1.0) * (count - 1);
    const int cell = std::min(static_cast<int>(position), count - 2);
    return {cell, position - cell};
}

/// Polar angle of a unit vector, accurate near the pole too.
inline double polar_angle(const Vec3& direction) {
    return std::atan2(std::sqrt(direction.x * direction.x + direction.y * direction.y), direction.z);
}

/// Azimuth of wo minus that of wi. A viewer at the pole is given azimuth 0, so that phi still varies with wi
/// and hemispherical integrals hold there too.
inline double relative_azimuth(const Vec3& wo, const Vec3& wi) {
    const bool at_pole = wo.x == 0 && wo.y == 0;
    const double ox = at_pole ? 1 : wo.x;
    return std::atan2(wi.x * wo.y - wi.y * ox, wi.x * ox + wi.y * wo.y);
}

/// The eight nodes around a geometry: rows of phi in the order (theta_i, theta_r), (next theta_i, theta_r),
/// (theta_i, next theta_r), (next, next), and the two places in each.
struct GridCell {
    std::size_t row[4];  ///< index of the row's first node
    std::size_t k0, k1;
    double i_fraction, k_fraction, j_fraction;
};

/// Nodes in memory: viewing angle slowest, phi fastest, so that the samples of one view lie together.
struct GridShape {
    int theta_i_count = 0;
    int phi_count = 0;
    int theta_r_count = 0;
    double phi_origin = 0;  ///< radians

    bool operator==(const GridShape&) const = default;

    std::size_t size() const {
        return static_cast<std::size_t>(theta_i_count) * static_cast<std::size_t>(phi_count) *
               static_cast<std::size_t>(theta_r_count);
    }
    std::size_t index(int i, int k, int j) const {
        return (static_cast<std::size_t>(j) * static_cast<std::size_t>(theta_i_count) +
                static_cast<std::size_t>(i)) *
                   static_cast<std::size_t>(phi_count) +
               static_cast<std::size_t>(k);
    }
    /// Angles in radians: theta in 0..pi/2, any phi.
    GridCell cell(double theta_i, double phi, double theta_r) const;
};

inline GridCell GridShape::cell(double theta_i, double phi, double theta_r) const {
    const GridPlace i = polar_place(theta_i, theta_i_count);
    const GridPlace j = polar_place(theta_r, theta_r_count);
    const double turns = (phi - phi_origin) / (2 * std::numbers::pi);
    const double position = (turns - std::floor(turns)) * phi_count;
    const int k0 = static_cast<int>(position) % phi_count;  // position may round up to phi_count
    const int k1 = k0 + 1 == phi_count ? 0 : k0 + 1;
    return {{index(i.cell, 0, j.cell), index(i.cell + 1, 0, j.cell), index(i.cell, 0, j.cell + 1),
             index(i.cell + 1, 0, j.cell + 1)},
            static_cast<std::size_t>(k0),
            static_cast<std::size_t>(k1),
            i.fraction,
            position - std::floor(position),
            j.fraction};
}

}  // namespace infra
