// A tabulated isotropic BRDF: trilinear interpolation, its split into a Lambertian and a lobe, its
// reflectance.
//
// Conventions: local frame with z the surface normal; wo points to the viewer (the reflected direction), wi
// to where the radiance comes from (the incident one); both leave the surface and have unit length. phi is
// the azimuth of wo minus that of wi, so that wo mirrors wi at phi = pi.
//
// The split: the largest constant that fits under every value, min f, is the Lambertian part, of reflectance
// D = pi min f; the rest, f - D/pi, is the lobe, nowhere negative. It is one constant for the whole table
// even where a file states one D per block, so that the Lambertian part is reciprocal. The D in a file is a
// claim that the reader checks against the data; a D below the largest would only leave a constant in the
// lobe, where it costs noise.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/vec.h"
#include "nrlbrdf/grid_shape.h"

namespace infra {

/// Values f [1/sr] on a regular grid: value(i, k, j) at
///   theta_i = i * 90 deg / (theta_i_count - 1), theta_r = j * 90 deg / (theta_r_count - 1),
///   phi = phi_origin + k * 360 deg / phi_count, all the way round (no row is repeated).
struct BrdfGrid {
    int theta_i_count = 0;  ///< >= 2
    int phi_count = 0;      ///< >= 2
    int theta_r_count = 0;  ///< >= 2
    double phi_origin = 0;  ///< radians; pi when the data's mirror direction was at row 0

    /// Finite and >= 0, theta_i slowest and theta_r fastest, as in a file.
    std::vector<float> values;
};

/// Immutable, so that threads share it.
class BrdfTable {
  public:
    /// Takes a valid grid (read_table_file gives only such ones); throws infra::Error when the sizes do not
    /// match.
    explicit BrdfTable(const BrdfGrid& grid);

    /// The same from values in the order of `shape`, with a given Lambertian part: constant = D/pi [1/sr], at
    /// most the smallest value.
    BrdfTable(const GridShape& shape, std::vector<float> values, double constant);

    /// f [1/sr] without the cosine; exact at every node and continuous. 0 when either direction is below the
    /// surface.
    double eval(const Vec3& wo, const Vec3& wi) const;

    /// f - D/pi >= 0 [1/sr]; what is left when the Lambertian part is calculated elsewhere.
    double eval_lobe(const Vec3& wo, const Vec3& wi) const;

    /// The same by angle in radians: theta in 0..pi/2, any phi.
    double eval_lobe(double theta_i, double phi, double theta_r) const;

    /// Reflectance D of the Lambertian part, 0..1.
    double diffuse_reflectance() const { return diffuse_; }

    /// Directional-hemispherical reflectance towards the viewer: the integral of f cos(theta_i) over all wi,
    /// at cos_theta_o = wo.z in 0..1. Exact for the interpolated table. Emissivity is 1 minus this
    /// (Kirchhoff).
    double reflectance_dh(double cos_theta_o) const;

    /// The lobe's share of it, reflectance_dh - D >= 0.
    double lobe_reflectance_dh(double cos_theta_o) const;

    /// The integral of f cos(theta_r) over all wo, for light that comes from the i-th incident angle.
    double incident_reflectance(int i) const;

    /// True when every value is the same: the table is a plain Lambertian.
    bool lobe_is_zero() const { return lobe_is_zero_; }

    const GridShape& shape() const { return shape_; }
    int theta_i_count() const { return shape_.theta_i_count; }
    int phi_count() const { return shape_.phi_count; }
    int theta_r_count() const { return shape_.theta_r_count; }
    double phi_origin() const { return shape_.phi_origin; }

    /// The lobe at a node; k counts as in BrdfGrid.
    double lobe_node(int i, int k, int j) const { return lobe_at(shape_.index(i, k, j)); }

    /// f [1/sr] at every node, in the order of shape().
    std::span<const float> values() const { return values_; }

    /// The lobe's lobe_reflectance_dh at the j-th viewing angle.
    double lobe_reflectance_node(int j) const { return lobe_reflectance_[static_cast<std::size_t>(j)]; }

  private:
    double lobe_at(std::size_t n) const { return static_cast<double>(values_[n]) - constant_; }

    GridShape shape_;
    double constant_;  // the Lambertian part, D / pi
    double diffuse_;
    bool lobe_is_zero_;
    std::vector<float> values_;
    std::vector<double> lobe_reflectance_;  // per viewing angle
};

/// The integral of the i-th hat function of a polar grid times cos(theta) sin(theta): with it the
/// hemispherical integral of an interpolated function is a sum over its nodes.
std::vector<double> polar_weights(int count);

}  // namespace infra
