// What a medium does to the radiance of a ray that has travelled through it: extinction, the light of
// listed sources scattered once into the ray, and an ambient term for the rest.
//
// source: RADIANCE reference manual, "Mist"; sample counts and the ambient term as measured from
// RADIANCE 6.1.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/photons/photon_maps.h"
#include "rt/scratch.h"
#include "rt/sources/source_aim.h"
#include "rt/split/split.h"
#include "rt/tracer.h"
#include "rt/volume/henyey_greenstein.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr float invisible = 1e-12f;  // transmittance from which on nothing is sampled
constexpr int most_places = 16;      // along a ray, whatever -ms says

int place_count(double distance, double step) {
    if (step <= tiny) return 1;
    return static_cast<int>(std::clamp(distance / step + 0.5, 1.0, double{most_places}));
}

}  // namespace

void Tracer::participate(Interaction& at) {
    const Medium& medium = *at.medium;
    if (medium.is_clear()) return;
    const bool to_source = at.ray->is(shadow_rays);
    Spectrum left(at.channels());
    if (to_source)
        medium.absorption_alone(at.distance, left);
    else
        medium.transmittance(at.distance, left);
    at.radiance *= left;
    at.mirrored *= left;
    if (at.sky) {
        at.sky->radiance *= left;
        at.sky->share *= left;
    }
    if (to_source || !medium.scatters()) return;
    const PhotonMaps* const maps = scene_.photons();
    const bool by_photons = maps && maps->volume();
    for (int c = 0; c < at.channels() && !by_photons; ++c)
        at.radiance.set(c, at.radiance[c] + medium.albedo[c] * scene_.ambient_value()[c] * (1.0f - left[c]));
    if (at.distance >= infinite_distance * 0.99 || medium.eccentricity >= 1.0 - tiny) return;
    if (by_photons) return add_scattered_photons(*maps, at);
    for (const int source : medium.sources) add_scattered(source, at);
}

// Light of a source scattered once, at places spread over the ray.
void Tracer::add_scattered(int source, Interaction& at) {
    const Medium& medium = *at.medium;
    const int places = place_count(at.distance, settings_.medium_step);
    const Spectrum scattering = medium.extinction * medium.albedo;
    Spectrum before(at.channels());
    for (int i = 0; i < places; ++i) {
        const double distance = at.distance * (i + random_.uniform()) / places;
        medium.transmittance(distance, before);
        if (before.maximum() <= invisible) return;
        Spectrum arriving(at.channels());
        const Spectrum share = scattering * before * static_cast<float>(at.distance / places);
        if (!light_at_place(source, distance, share, at, arriving)) continue;
        if (split_) split_->into_path(arriving);
        at.radiance.add_scaled(arriving * scattering * before, static_cast<float>(at.distance / places));
    }
}

// All scattered light, from the density of photons at places spread over the ray.
void Tracer::add_scattered_photons(const PhotonMaps& maps, Interaction& at) {
    const Medium& medium = *at.medium;
    const int places = place_count(at.distance, settings_.medium_step);
    const Spectrum scattering = medium.extinction * medium.albedo;
    Spectrum before(at.channels()), arriving(at.channels());
    for (int i = 0; i < places; ++i) {
        const double distance = at.distance * (i + random_.uniform()) / places;
        medium.transmittance(distance, before);
        if (before.maximum() <= invisible) return;
        const PhotonColor color =
            scratch_->photons.volume(*maps.volume(), at.ray->origin + at.ray->direction * distance,
                                     at.ray->direction, medium.eccentricity);
        for (int c = 0; c < at.channels(); ++c)
            arriving.set(c, static_cast<float>(color[static_cast<std::size_t>(c)]));
        at.radiance.add_scaled(arriving * scattering * before, static_cast<float>(at.distance / places));
    }
}

// Radiance that a place along the ray scatters back along it, per scattering coefficient, were the source all
// its light; `share` of it comes out of the ray's other end.
bool Tracer::light_at_place(int source, double distance, const Spectrum& share, const Interaction& at,
                            Spectrum& result) {
    Ray ray(at.channels());
    ray.origin = at.ray->origin + at.ray->direction * distance;
    const LightSource& aimed = scene_.source(source);
    if (aimed.skip || is_out_of_reach(aimed, ray.origin)) return false;
    constexpr Part whole{{0, 0}, {1, 1}};
    SourceAim aim;
    const Vec3 place = place_on(aimed, whole, true, settings_.source_jitter, random_);
    if (!aim_at(aimed, ray.origin, place, 1.0, aim)) return false;
    ray.direction = aim.direction;
    ray.parent = &at;
    ray.kind = ray.lineage = reflected_shadow;
    ray.aimed_source = source;
    ray.medium = at.medium;
    ray.cut = at.ray->cut;
    ray.fore = at.ray->fore;
    ray.path_before = at.ray->path_before + distance;
    ray.level = at.ray->level;
    const double phase = henyey_greenstein(at.medium->eccentricity, dot(at.ray->direction, ray.direction));
    ray.coefficient = share * static_cast<float>(phase * aim.omega);
    ray.starts_within = true;
    Interaction seen(ray);
    trace(seen);
    if (seen.radiance.brightness() <= static_cast<float>(tiny)) return false;
    result = seen.radiance * static_cast<float>(phase * aim.omega);
    return true;
}

}  // namespace infra
