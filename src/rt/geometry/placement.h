// Where an instance stands: what it contains is rotated or mirrored, scaled and moved.
//
// An orthogonal matrix, a factor and an origin say it in both directions, so that a scene with many instances
// keeps 104 bytes for each.
#pragma once

#include "common/vec.h"
#include "scene/transform.h"

namespace infra {

class Placement {
  public:
    Placement() = default;
    explicit Placement(const Transform& to_outside)
        : origin_(to_outside.point(Vec3{0})), scale_(to_outside.magnification()) {
        for (int i = 0; i < 3; ++i) {
            const auto& row = to_outside.matrix[static_cast<std::size_t>(i)];
            axis_[i] = Vec3{row[0], row[1], row[2]} / scale_;
        }
    }

    /// Factor of lengths on the way outside, > 0.
    double scale() const { return scale_; }

    Vec3 point_outside(const Vec3& p) const { return origin_ + direction_outside(p) * scale_; }
    Vec3 point_inside(const Vec3& p) const { return direction_inside(p - origin_) / scale_; }
    /// Directions keep their length. A mirrored placement mirrors them too: normals need no turning.
    Vec3 direction_outside(const Vec3& d) const { return axis_[0] * d.x + axis_[1] * d.y + axis_[2] * d.z; }
    Vec3 direction_inside(const Vec3& d) const {
        return {dot(axis_[0], d), dot(axis_[1], d), dot(axis_[2], d)};
    }

    /// Of something placed by `inner` in here, seen from outside.
    Placement around(const Placement& inner) const {
        Placement whole;
        for (int i = 0; i < 3; ++i) whole.axis_[i] = direction_outside(inner.axis_[i]);
        whole.origin_ = point_outside(inner.origin_);
        whole.scale_ = scale_ * inner.scale_;
        return whole;
    }

    /// From outside to inside; its scale is positive also where it mirrors, as in RADIANCE.
    Transform to_inside() const {
        Transform inside;
        inside.scale = 1 / scale_;
        for (std::size_t j = 0; j < 3; ++j) {
            const Vec3& axis = axis_[j];
            for (int i = 0; i < 3; ++i) inside.matrix[static_cast<std::size_t>(i)][j] = axis[i] / scale_;
            inside.matrix[3][j] = -dot(origin_, axis) / scale_;
        }
        return inside;
    }

  private:
    Vec3 axis_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< where the inner axes point, unit lengths
    Vec3 origin_{0};
    double scale_ = 1;
};

}  // namespace infra
