#include "rt/materials/surface_material.h"

#include "rt/tracer.h"

namespace infra {

bool SurfaceMaterial::shade(Tracer& tracer, Interaction& at) const {
    const bool shadow = at.ray->is(shadow_rays);
    if (shadow && traits_.blocks_light) return true;
    if (at.cosine < 0 && sides_.back_may_hide && !tracer.settings().back_faces_visible) {
        tracer.pass_through(at);
        return true;
    }
    tracer.apply_patterns(next(), at);
    if (at.cosine < 0) at.flip();
    Scattering scattering(at.perturbed_normal(), at.channels());
    scatter(tracer, at, shadow, scattering);
    tracer.transport(scattering, at);
    if (at.flipped && !sides_.turns_to_viewer) at.flip();
    return true;
}

}  // namespace infra
