#include "scene/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace infra {
namespace {

constexpr double flat_area = 1e-10;     // twice the area of corners in line (RADIANCE's)
constexpr double least_normal = 1e-12;  // that of corners that span a plane

/// Positive if c lies to the left of the way from a to b.
template <class Point>
double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

template <class Point>
bool same(const Point& a, const Point& b) {
    return a.x == b.x && a.y == b.y;
}

int largest_component(const Vec3& v) {
    int axis = 2;
    for (const int i : {1, 0})
        if (std::abs(v[i]) > std::abs(v[axis])) axis = i;
    return axis;
}

}  // namespace

/// Along the axis of the last three corners in a row that span a plane. Returns false if none do.
bool Triangulator::project(std::span<const Vec3> corners) {
    for (std::size_t i = corners.size() - 2; i-- > 0;) {
        const Vec3 normal = cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i + 1]);
        const int axis = largest_component(normal);
        if (std::abs(normal[axis]) <= least_normal) continue;
        points_.clear();
        for (const Vec3& p : corners) points_.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3]});
        return true;
    }
    return false;
}

double Triangulator::signed_area() const {
    double doubled = 0;
    const Point* last = &points_.back();
    for (const Point& p : points_) {
        doubled += last->x * p.y - p.x * last->y;
        last = &p;
    }
    return 0.5 * doubled;
}

Triangulator::Ear Triangulator::ear(std::size_t u, std::size_t v, std::size_t w) const {
    const Point &a = points_[left_[u]], &b = points_[left_[v]], &c = points_[left_[w]];
    const double area = turn(a, b, c);
    if (area < flat_area) return area > -flat_area ? Ear::flat : Ear::no;
    for (std::size_t i = 0; i < left_.size(); ++i) {
        if (i == u || i == v || i == w) continue;
        const Point& p = points_[left_[i]];
        if (same(p, a) || same(p, b) || same(p, c)) continue;  // the seam of a hole
        if (turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && turn(a, b, p) >= 0) return Ear::no;
    }
    return Ear::yes;
}

Triangulation Triangulator::operator()(std::span<const Vec3> corners, const Output& output) {
    if (!project(corners)) return Triangulation::degenerate;
    const double area = signed_area();
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), 0);
    if (area <= 0) std::reverse(left_.begin(), left_.end());

    // Round and round: the tip moves on by one after every try, cut or not.
    std::size_t tip = left_.size() - 1;
    for (std::size_t tries = 2 * left_.size(); left_.size() > 2;) {
        if (tries-- == 0) return Triangulation::partial;
        const std::size_t u = tip < left_.size() ? tip : 0;
        const std::size_t v = u + 1 < left_.size() ? u + 1 : 0;
        const std::size_t w = v + 1 < left_.size() ? v + 1 : 0;
        tip = v;
        const Ear found = ear(u, v, w);
        if (found == Ear::no) continue;
        const std::array<int, 3> cut = {left_[u], left_[v], left_[w]};
        if (found == Ear::yes) output(area < 0 ? std::array{cut[2], cut[1], cut[0]} : cut);
        left_.erase(left_.begin() + std::ptrdiff_t(v));
        tries = 2 * left_.size();
    }
    return Triangulation::whole;
}

}  // namespace infra
