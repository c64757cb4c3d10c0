// One of the up to four tables of a BSDF: reflection or transmission of light that meets one side.
//
// Directions have unit length and leave the surface; z is the normal of the front. Of a pair, `in` and `out`
// name the table's two sides of incidence; which of them light comes from makes no difference to a BSDF that
// is reciprocal, and the ray tracer hands in the viewer's direction as `in`, as RADIANCE does. A table of
// transmission answers for pairs from the other side too, by reciprocity.
#pragma once

#include <cstddef>

#include "bsdf/tristimulus.h"
#include "common/vec.h"

namespace infra {

/// Where a table's light comes from and goes to.
struct ScatterSides {
    bool from_front = true;
    bool transmits = false;
    bool to_front() const { return from_front != transmits; }
};

/// What a table holds for a pair of directions.
struct ScatterEntry {
    static constexpr std::size_t none = ~std::size_t(0);

    std::size_t cell = none;           ///< the same for all pairs that share the value
    double value = 0;                  ///< f [1/sr] without its Lambertian part: luminance of a coloured one
    double projected_solid_angle = 0;  ///< resolution there [sr]: of the smaller of both patches
};

/// Least and largest projected solid angle [sr] of the patches that share a direction.
struct ResolutionRange {
    double least, largest;
};

class ScatterTable {
  public:
    virtual ~ScatterTable() = default;

    virtual ScatterEntry entry(const Vec3& in, const Vec3& out) const = 0;
    /// The colour of entry().value, with that luminance; asked of colored() tables only.
    virtual Xyz color(const Vec3& in, const Vec3& out) const = 0;

    virtual ResolutionRange resolution(const Vec3& in) const = 0;

    /// Directional-hemispherical reflectance or transmittance of what entry() has, for light from or a view
    /// at `in`, on either side if the table transmits.
    virtual double total(const Vec3& in) const = 0;
    /// A direction with density entry(in, out).value * |cos| / total(in) for numbers uniform in 0..1: the
    /// first chooses a patch, the others a place in it. total(in) must not be 0.
    virtual Vec3 sample(const Vec3& in, double choice, double u, double v) const = 0;

    ScatterSides sides() const { return sides_; }
    bool colored() const { return colored_; }
    /// Smallest projected solid angle anywhere [sr].
    double least_projected_solid_angle() const { return least_projected_solid_angle_; }
    /// Largest total() of any direction.
    double largest_total() const { return largest_total_; }
    /// The Lambertian part, as reflectance or transmittance.
    const Xyz& lambertian() const { return lambertian_; }

  protected:
    explicit ScatterTable(ScatterSides sides) : sides_(sides) {}

    ScatterSides sides_;
    bool colored_ = false;
    double least_projected_solid_angle_ = 0;
    double largest_total_ = 0;
    Xyz lambertian_{0};
};

/// RADIANCE leaves a Lambertian part of less than this reflectance in the table.
inline constexpr double least_lambertian = 0.01;

}  // namespace infra
