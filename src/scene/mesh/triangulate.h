// Faces of any number of corners as triangles.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "common/vec.h"

namespace infra {

enum class Triangulation {
    whole,
    degenerate,  ///< no three corners in a row span a triangle: nothing to hand on
    partial,     ///< it crosses itself; what could be cut off before that was found has been handed on
};

/// Cuts ears off plane faces, concave ones too; corners in line with their neighbours go without a triangle.
/// Keep one for many faces: it holds on to its memory.
class Triangulator {
  public:
    /// Called with the places of three corners in the face, in the face's sense of rotation.
    using Output = std::function<void(std::array<int, 3>)>;

    /// The corners are looked at along the axis nearest to the face's normal.
    Triangulation operator()(std::span<const Vec3> corners, const Output& output);

  private:
    struct Point {
        double x, y;
    };
    enum class Ear { no, yes, flat };

    /// The ear with its tip at place v of the points left.
    Ear ear(std::size_t u, std::size_t v, std::size_t w) const;
    bool project(std::span<const Vec3> corners);
    double signed_area() const;

    std::vector<Point> points_;
    std::vector<int> left_;  // corners not yet cut off, counterclockwise as projected
};

}  // namespace infra
