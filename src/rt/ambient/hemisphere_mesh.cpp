#include "rt/ambient/hemisphere_mesh.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace infra {
namespace {

constexpr double end_on = 1e-9;  // sine of the angle at which an edge is too short to count

double cube(double x) { return x * x * x; }

/// Brightness of a triangle: that of its farthest corner, for a nearer one may stand in front of what the
/// triangle shows.
double value_of(const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    const MeshCorner& farther = a.nearness <= b.nearness ? a : b;
    return (farther.nearness <= c.nearness ? farther : c).value;
}

}  // namespace

void ShareDerivatives::add(const ShareDerivatives& other, double factor) {
    x += factor * other.x;
    y += factor * other.y;
    xx += factor * other.xx;
    xy += factor * other.xy;
    yy += factor * other.yy;
}

// The share is (1/2pi) c.z I with c = a x b and I the integral of 1/r^2 along the edge. Derivatives put 1/r^4
// and r r/r^6 under the integral; with h the distance of the edge's line and t the angle along it from the
// foot f of the perpendicular, r = h (f + tan(t) e), all of them are integrals of powers of sin and cos.
ShareDerivatives edge_derivatives(const Vec3& a, const Vec3& b) {
    constexpr double pi = std::numbers::pi;
    const Vec3 along = b - a;
    const double size = length(along), length_a = length(a), length_b = length(b);
    const double area = length(cross(a, b));
    if (!(area > end_on * length_a * length_b) || !(size > 0)) return {};
    const Vec3 e = along / size;
    const double h = area / size;
    const double begin = dot(a, e), end = dot(b, e);
    const Vec3 f = (a - e * begin) / h;

    const double angle = std::atan2(area, dot(a, b));
    const double sin_a = begin / length_a, cos_a = h / length_a, sin_b = end / length_b, cos_b = h / length_b;
    const double cos2 = 0.5 * (angle + sin_b * cos_b - sin_a * cos_a);
    const double sin_cos = 0.5 * (sin_b * sin_b - sin_a * sin_a);
    const double cos4 = 0.25 * (sin_b * cube(cos_b) - sin_a * cube(cos_a)) + 0.75 * cos2;
    const double sin_cos3 = 0.25 * (cos_a * cube(cos_a) - cos_b * cube(cos_b));
    const double sin2_cos2 = cos2 - cos4;

    const double lift = f.x * e.y - f.y * e.x;  // z of f x e
    const double qx = f.x * cos2 + e.x * sin_cos, qy = f.y * cos2 + e.y * sin_cos;
    const auto moment = [&](double fi, double fj, double ei, double ej) {
        return fi * fj * cos4 + (fi * ej + ei * fj) * sin_cos3 + ei * ej * sin2_cos2;
    };
    const double first = 1 / (2 * pi * h), second = 1 / (pi * h * h);
    return {.x = first * (-e.y * angle + 2 * lift * qx),
            .y = first * (e.x * angle + 2 * lift * qy),
            .xx = second * (-2 * e.y * qx + lift * (4 * moment(f.x, f.x, e.x, e.x) - cos2)),
            .xy = second * (e.x * qx - e.y * qy + lift * 4 * moment(f.x, f.y, e.x, e.y)),
            .yy = second * (2 * e.x * qy + lift * (4 * moment(f.y, f.y, e.y, e.y) - cos2))};
}

namespace {

/// Adds up a mesh's edges: every one once, times what lies to its left less what lies to its right. A cell of
/// the grid is cut in two along the diagonal from (i + 1, j) to (i, j + 1).
class MeshSum {
  public:
    MeshSum(int n, std::span<const MeshCorner> corners) : last_(n - 1), corners_(corners) {}

    MeshDerivatives sum() {
        for (int i = 0; i <= last_; ++i)
            for (int j = 0; j <= last_; ++j) {
                if (i < last_ && j > 0 && j < last_)
                    add(result_.inner, corner(i, j).place, corner(i + 1, j).place,
                        low(i, j) - high(i, j - 1));
                if (j < last_ && i > 0 && i < last_)
                    add(result_.inner, corner(i, j + 1).place, corner(i, j).place,
                        low(i, j) - high(i - 1, j));
                if (i < last_ && j < last_)
                    add(result_.inner, corner(i + 1, j).place, corner(i, j + 1).place,
                        low(i, j) - high(i, j));
            }
        walk_rim();
        return result_;
    }

  private:
    const MeshCorner& corner(int i, int j) const {
        return corners_[static_cast<std::size_t>(i * (last_ + 1) + j)];
    }
    /// Values of the triangles of a cell: at its corner (i, j), and at (i + 1, j + 1).
    double low(int i, int j) const { return value_of(corner(i, j), corner(i + 1, j), corner(i, j + 1)); }
    double high(int i, int j) const {
        return value_of(corner(i + 1, j + 1), corner(i, j + 1), corner(i + 1, j));
    }

    static void add(ShareDerivatives& sum, const Vec3& a, const Vec3& b, double step) {
        if (step != 0) sum.add(edge_derivatives(a, b), step);
    }

    // Around the mesh, which lies to the left.
    void walk_rim() {
        first_ = before_ = low(0, 0);
        for (int k = 0; k < last_; ++k) add_rim(corner(k, 0).place, corner(k + 1, 0).place, low(k, 0));
        for (int k = 0; k < last_; ++k)
            add_rim(corner(last_, k).place, corner(last_, k + 1).place, high(last_ - 1, k));
        for (int k = last_; k > 0; --k)
            add_rim(corner(k, last_).place, corner(k - 1, last_).place, high(k - 1, last_ - 1));
        for (int k = last_; k > 0; --k) add_rim(corner(0, k).place, corner(0, k - 1).place, low(0, k - 1));
    }

    // Below the rim each triangle goes on straight down to the horizon. All of the horizon together does not
    // change with the place, so that values may count from any of them.
    void add_rim(const Vec3& a, const Vec3& b, double value) {
        const ShareDerivatives edge = edge_derivatives(a, b);
        result_.rim.add(edge, value);
        result_.shape.add(edge, 1);
        const Vec3 foot = on_horizon(a);
        add(result_.skirt, a, foot, value - before_);
        add(result_.skirt, foot, on_horizon(b), value - first_);
        before_ = value;
    }

    static Vec3 on_horizon(const Vec3& place) {
        const double across = std::hypot(place.x, place.y);
        return across > 0 ? Vec3(place.x, place.y, 0) * (length(place) / across) : Vec3(0);
    }

    const int last_;
    const std::span<const MeshCorner> corners_;
    double first_ = 0, before_ = 0;  // values of the rim's first triangle and of the one before
    MeshDerivatives result_;
};

}  // namespace

MeshDerivatives mesh_derivatives(int n, std::span<const MeshCorner> corners) {
    return MeshSum(n, corners).sum();
}

Bend bend(const ShareDerivatives& second) {
    const double middle = 0.5 * (second.xx + second.yy), half = 0.5 * (second.xx - second.yy);
    const double spread = std::hypot(half, second.xy);
    double angle = 0.5 * std::atan2(second.xy, half);  // of the larger, middle + spread
    double larger = std::fabs(middle + spread), smaller = std::fabs(middle - spread);
    if (smaller > larger) {
        std::swap(larger, smaller);
        angle += 0.5 * std::numbers::pi;
    }
    return {std::cos(angle), std::sin(angle), larger, smaller};
}

}  // namespace infra
