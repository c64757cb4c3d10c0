// RADIANCE's transform options (-t x y z, -rx deg, -s factor, -mx, -i count ...) as 4x4 matrices.
// Points are row vectors: p' = p * matrix, so translation stands in the last row.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "common/vec.h"

namespace infra {

using Matrix4 = std::array<std::array<double, 4>, 4>;

inline constexpr Matrix4 identity4 = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

/// a applied first, then b.
Matrix4 multiply(const Matrix4& a, const Matrix4& b);

/// A similarity: rotation, uniform scale, translation and mirroring.
struct Transform {
    Matrix4 matrix = identity4;
    double scale = 1.0;  ///< uniform scale factor; negative when the transform mirrors

    /// Length factor, > 0.
    double magnification() const { return scale < 0 ? -scale : scale; }
    /// True when front and back of a surface change places.
    bool mirrors() const { return scale < 0; }

    /// A position.
    Vec3 point(const Vec3& p) const {
        const auto& m = matrix;
        const Vec3 turned = vector(p);
        return {turned.x + m[3][0], turned.y + m[3][1], turned.z + m[3][2]};
    }
    /// A direction: rotated and scaled, not moved.
    Vec3 vector(const Vec3& v) const {
        const auto& m = matrix;
        return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
                v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
    }

    Transform inverse() const;
};

/// a applied first, then b.
Transform operator*(const Transform& a, const Transform& b);

/// True for the words that begin a transform: -t -s -i -rx -ry -rz -mx -my -mz.
bool is_transform_option(std::string_view word);

/// Reads the longest run of transform options at the beginning of `words`, as RADIANCE's library does:
/// it stops at the first word that is not one, or that lacks its numbers (or scales by zero).
///   returns  the number of words read; `transform` is what they amount to
/// shape: Range elements are std::string, std::string_view or const char*.
std::size_t parse_transform(std::span<const std::string_view> words, Transform& transform);
std::size_t parse_transform(std::span<const std::string> words, Transform& transform);

}  // namespace infra
