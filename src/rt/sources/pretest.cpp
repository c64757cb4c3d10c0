// source: the number of rays is RADIANCE 6.1's (-dp).
#include "rt/sources/pretest.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/sources/source_aim.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;  // radiance that counts as none
constexpr Part whole{{0, 0}, {1, 1}};
constexpr int fewest_rays = 16;
constexpr int tries_per_ray = 32;  // to hit a surface that fills its disk badly

}  // namespace

// By the solid angle of the disk from a local source; by its share of the scene for a distant one.
int Pretest::ray_count(const RelaySurface& surface, const LightSource& source) const {
    const double radius2 = surface.disk.radius * surface.disk.radius;
    double share = 0;
    if (source.distant()) {
        const Bounds& box = tracer_.scene().geometry().bounds();
        const Vec3 size = box.hi - box.lo;
        const double edge = std::max({size.x, size.y, size.z});
        share = 32 * radius2 / (edge * edge);
    } else {
        const Vec3 offset = surface.disk.center - source.center;
        const double distance2 = dot(offset, offset);
        share = 2 * std::numbers::pi * (1.0 - std::sqrt(distance2 / (distance2 + radius2)));
    }
    const double count = share * tracer_.settings().direct_pretest + 0.5;
    return static_cast<int>(std::clamp<double>(count, fewest_rays, most_samples));
}

// A place on the surface by throws into the square around its disk.
bool Pretest::find_point(const RelaySurface& surface, int& tries, Vec3& point) {
    Vec3 u, v;
    make_frame(surface.normal, u, v);
    RandomStream& random = tracer_.random();
    while (tries-- > 0) {
        const Vec3 place = surface.disk.center + u * (surface.disk.radius * (1 - 2 * random.uniform())) +
                           v * (surface.disk.radius * (1 - 2 * random.uniform()));
        const Ray ray = tracer_.primary(place + surface.normal * surface.disk.radius, -surface.normal, 0);
        Interaction at(ray);
        if (!tracer_.meet(surface.surface, at)) continue;
        point = at.point;
        return true;
    }
    return false;
}

bool Pretest::arrives(int source, const RelaySurface& surface, const Vec3& point, const Vec3& direction) {
    Ray ray = tracer_.primary(point, direction, 0);
    ray.kind = ray.lineage = reflected_shadow;
    ray.aimed_source = source;
    ray.leaving.shape = tracer_.scene().geometry().shape_of(surface.surface);
    Interaction at(ray);
    tracer_.trace(at);
    return at.radiance.mean() > tiny;
}

bool Pretest::sees(const RelaySurface& surface, int number) {
    if (tracer_.settings().direct_pretest <= 0) return true;
    const LightSource& source = tracer_.scene().source(number);
    tracer_.start_stream(static_cast<std::uint64_t>(number) << 32 |
                         static_cast<std::uint32_t>(surface.surface));
    const int rays = ray_count(surface, source);
    int tries = rays > most_samples / tries_per_ray ? most_samples : rays * tries_per_ray;
    for (int i = 0; i < rays; ++i) {
        Vec3 point;
        if (!find_point(surface, tries, point)) return true;
        const Vec3 place = place_on(source, whole, true, 1.0, tracer_.random());
        SourceAim aim;
        if (aim_at(source, point, place, 1.0, aim) && arrives(number, surface, point, aim.direction))
            return true;
    }
    return false;
}

}  // namespace infra
