// Where photons take the place of rays, as in RADIANCE: at the end of a diffuse bounce, for caustics on what
// the eye sees, and, to test maps, for direct light. Media: volume/participation.cpp.
#include <numbers>

#include "rt/materials/scattering.h"
#include "rt/photons/photon_maps.h"
#include "rt/scratch.h"
#include "rt/tracer.h"

namespace infra {
namespace {

void set(Spectrum& spectrum, const PhotonColor& color) {
    for (int c = 0; c < 3; ++c) spectrum.set(c, static_cast<float>(color[static_cast<std::size_t>(c)]));
}

}  // namespace

// Whether a map has what specular surfaces do with light on its way to a diffuse one that has sent out `ray`.
// The bounce next to the eye still looks through panes.
bool Tracer::is_in_photon_map(const Ray& ray) const {
    return scene_.photons() && scene_.photons()->cover_surfaces() && ray.is(ambient_rays) && ray.level > 1;
}

// The same for a ray that would go on from the end of one.
bool Tracer::continuation_is_in_photon_map(const Ray& ray, bool straight_on) const {
    const PhotonMaps* const maps = scene_.photons();
    if (!maps || !ray.is(ambient_rays) || !maps->cover_surfaces()) return false;
    return maps->cover_transmission() || !straight_on;
}

// Adds what maps say of indirect light. True if that is all of it.
bool Tracer::add_photons(const Spectrum& coefficient, bool other_side, Interaction& at) {
    const PhotonMaps& maps = *scene_.photons();
    const bool later_bounce = at.ray->ambient_level > 0;
    const PhotonSource* const indirect = maps.indirect();
    const bool complete = indirect && (later_bounce || settings_.ambient_bounces < 0);
    const bool focused = !complete && maps.caustic() && (!later_bounce || !indirect);
    if (!complete && !focused) return false;
    if (at.surface >= 0 && scene_.finish(at.surface).is_light()) return complete;
    const Vec3 normal = other_side ? -at.normal : at.normal;
    Spectrum radiance(at.channels());
    const PhotonSource& source = complete ? *indirect : *maps.caustic();
    const bool only_caustic = focused && source.photons.kind() == PhotonKind::contribution;
    set(radiance, scratch_->photons.surface(source, at.point, normal, only_caustic, random_));
    at.radiance.add_product(radiance, coefficient);
    return complete;
}

void Tracer::add_direct_photons(const Scattering& scattering, Interaction& at) {
    if (at.surface >= 0 && scene_.finish(at.surface).is_light()) return;
    constexpr double half_space = std::numbers::pi;  // projected solid angle
    Spectrum coefficient(at.channels()), radiance(at.channels());
    scattering.eval(at.normal, half_space, !is_in_photon_map(*at.ray), coefficient);
    set(radiance,
        scratch_->photons.surface(*scene_.photons()->direct(), at.point, at.normal, false, random_));
    at.radiance.add_scaled(radiance * coefficient, static_cast<float>(half_space));
}

}  // namespace infra
