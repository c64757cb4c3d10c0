#include "rt/guiding/guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "rt/guiding/cone_direction.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
/// 1 less the cosine of the narrowest cone: still told from a point by what dot products can resolve.
constexpr double narrowest = 1e-9;

}  // namespace

Guide::Guide(DirectionMap sky, double sky_excess, std::vector<HotSpot> spots)
    : sky_(std::move(sky)), sky_excess_(sky_excess), spots_(std::move(spots)) {}

Lookout::Lookout(const Guide& guide, const Vec3& point) : guide_(guide) {
    double sum = guide.sky_excess();
    for (const HotSpot& spot : guide.spots()) {
        Cone& cone = cones_[static_cast<std::size_t>(count_)];
        double share = spot.excess;  // of what arrives here
        if (spot.distant) {
            cone.axis = spot.center;
            cone.least_cosine = spot.radius;
        } else {
            const Vec3 way = spot.center - point;
            const double distance2 = dot(way, way), radius2 = spot.radius * spot.radius;
            const bool inside = distance2 <= radius2;
            cone.axis = inside ? Vec3{0, 0, 1} : way / std::sqrt(distance2);
            cone.least_cosine = inside ? -1.0 : std::sqrt(1 - radius2 / distance2);
            share /= std::max(distance2, radius2);
        }
        cone.least_cosine = std::min(cone.least_cosine, 1 - narrowest);
        const double size = 2 * pi * (1 - cone.least_cosine);
        cone.density = share / size;
        chance_[static_cast<std::size_t>(count_)] = share;
        ++count_;
        sum += share;
    }
    sky_chance_ = sum > 0 ? guide.sky_excess() / sum : 0.0;
    for (int i = 0; i < count_; ++i) {
        chance_[static_cast<std::size_t>(i)] /= sum;
        cones_[static_cast<std::size_t>(i)].density /= sum;
    }
}

Vec3 Lookout::sample(double u, double v) const {
    if (u < sky_chance_) return guide_.sky().sample(u / sky_chance_, v);
    u -= sky_chance_;
    int chosen = 0;
    while (chosen + 1 < count_ && u >= chance_[static_cast<std::size_t>(chosen)])
        u -= chance_[static_cast<std::size_t>(chosen++)];
    const Cone& cone = cones_[static_cast<std::size_t>(chosen)];
    const double turn = std::min(u / chance_[static_cast<std::size_t>(chosen)], 1.0);
    return cone_direction(cone.axis, cone.least_cosine, turn, v);
}

double Lookout::pdf(const Vec3& direction) const {
    double density = sky_chance_ > 0 ? sky_chance_ * guide_.sky().pdf(direction) : 0.0;
    for (int i = 0; i < count_; ++i) {
        const Cone& cone = cones_[static_cast<std::size_t>(i)];
        if (dot(direction, cone.axis) >= cone.least_cosine) density += cone.density;
    }
    return density;
}

}  // namespace infra
