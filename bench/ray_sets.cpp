#include "ray_sets.h"

#include <cmath>
#include <numbers>

#include "common/random.h"

namespace infra::bench {
namespace {

class RayMaker {
  public:
    RayMaker(const Geometry& geometry, std::size_t count) : geometry_(geometry), count_(count) {
        size_ = length(geometry.bounds().hi - geometry.bounds().lo);
    }

    RaySet random() {
        RaySet set{"random", {}};
        while (set.rays.size() < count_) set.rays.push_back(random_ray());
        return set;
    }
    RaySet bounce() {
        RaySet set{"bounce", {}};
        while (set.rays.size() < count_) set.rays.push_back(bounced(random_hit()));
        return set;
    }
    RaySet hemisphere() {
        RaySet set{"hemisphere", {}};
        while (set.rays.size() < count_) {
            const Place place = random_hit();
            for (int n = 0; n < 1024; ++n) set.rays.push_back(bounced(place));
        }
        return set;
    }
    RaySet camera() {
        RaySet set{"camera", {}};
        const Bounds& box = geometry_.bounds();
        const Vec3 target = (box.lo + box.hi) * 0.5;
        const Vec3 forward = normalize(Vec3{-0.55, 0.75, -0.35});
        const Vec3 right = normalize(cross(forward, Vec3{0, 0, 1}));
        const Vec3 up = cross(right, forward);
        const Vec3 eye = target - forward * size_;
        const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count_)));
        for (std::size_t row = 0; row < side; ++row)
            for (std::size_t column = 0; column < side; ++column) {
                const double x = 0.6 * (static_cast<double>(column) / static_cast<double>(side) - 0.5);
                const double y = 0.25 * (0.5 - static_cast<double>(row) / static_cast<double>(side));
                set.rays.push_back({eye, normalize(forward + right * x + up * y), {}, 2 * size_});
            }
        return set;
    }

  private:
    struct Place {
        Vec3 point, normal;
        PlacedShape shape;
    };

    TestRay random_ray() {
        const Bounds& box = geometry_.bounds();
        const Vec3 size = box.hi - box.lo;
        const Vec3 origin = box.lo + Vec3{size.x * uniform(), size.y * uniform(), size.z * uniform()};
        const double z = 2 * uniform() - 1, turn = 2 * std::numbers::pi * uniform();
        const double r = std::sqrt(1 - z * z);
        return {origin, {r * std::cos(turn), r * std::sin(turn), z}, {}, 0.2 * size_};
    }
    Place random_hit() {
        for (;;) {
            const TestRay ray = random_ray();
            HitState state;
            geometry_.intersect(ray.origin, ray.direction, {}, state);
            if (state.surface < 0) continue;
            const Vec3 point = ray.origin + ray.direction * state.distance;
            const Vec3 normal = geometry_.normal(state.shape, point);
            return {point, dot(normal, ray.direction) > 0 ? -normal : normal, {state.shape, 0}};
        }
    }
    TestRay bounced(const Place& place) {
        Vec3 u, v;
        make_frame(place.normal, u, v);
        const double r2 = uniform(), r = std::sqrt(r2), turn = 2 * std::numbers::pi * uniform();
        const Vec3 direction =
            u * (r * std::cos(turn)) + v * (r * std::sin(turn)) + place.normal * std::sqrt(1 - r2);
        return {place.point, normalize(direction), place.shape, 0.2 * size_};
    }
    double uniform() { return stream_.uniform(); }

    const Geometry& geometry_;
    std::size_t count_;
    double size_;
    RandomStream stream_{5, 0};
};

}  // namespace

std::vector<RaySet> make_ray_sets(const Geometry& geometry, std::size_t count) {
    RayMaker make(geometry, count);
    return {make.random(), make.bounce(), make.hemisphere(), make.camera()};
}

}  // namespace infra::bench
