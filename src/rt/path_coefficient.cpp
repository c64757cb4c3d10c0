#include "rt/path_coefficient.h"

#include "common/data/air_path.h"

namespace infra {
namespace {

constexpr double distant = infinite_distance * 0.99;

bool is_camera_ray(const Ray& ray) { return !(ray.lineage & ~(primary_ray | through_ray)); }

/// The air dims what is met along a camera ray, and what is seen through that.
void apply_air(const AirPath& air, const Interaction& link, Spectrum& product) {
    if (!is_camera_ray(*link.ray) || link.distance >= distant) return;
    const double start = link.ray->fore + link.ray->path_before;
    Spectrum transmittance(product.channels()), radiance(product.channels());
    air.stretch(link.ray->parent ? start : 0.0, start + link.distance, transmittance, radiance);
    product *= transmittance;
}

}  // namespace

Spectrum path_coefficient(const Interaction& at, const AirPath* air) {
    Spectrum product(at.channels(), 1.0f), left(at.channels());
    // The sky is given as the camera sees it, whatever clear things it is seen through.
    if (air && is_camera_ray(*at.ray) && at.distance >= distant) air = nullptr;
    bool from_its_end = true;
    for (const Interaction* link = &at; link; link = link->ray->parent) {
        const Ray& ray = *link->ray;
        product *= ray.coefficient * static_cast<float>(link->share * ray.sample_weight);
        if (ray.tint) product *= *ray.tint;
        if (link->medium && from_its_end) {
            if (ray.is(shadow_rays))
                link->medium->absorption_alone(link->distance, left);
            else
                link->medium->transmittance(link->distance, left);
            product *= left;
        }
        if (air) apply_air(*air, *link, product);
        from_its_end = !ray.starts_within;
    }
    return product;
}

}  // namespace infra
