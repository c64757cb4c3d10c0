// emissive: a surface that emits and reflects.
//
//     mod emissive id
//     0 | 1 material
//     0
//     3 | 4 Lr Lg Lb [maxrad]
//
// Radiance leaving is Le, the same in every direction and from both sides, plus what `material` reflects and
// transmits; `material` is any earlier material or mixture, with patterns of its own, or void for a black
// emitter. Patterns on `mod` scale Le. maxrad is that of glow: within it the front is sampled as a light
// source; with 0 (or without it) indirect rays find the surface.
#include "rt/materials/emissive_material.h"
#include "rt/materials/wrapper.h"
#include "rt/tracer.h"

namespace infra {

EmissiveMaterial::EmissiveMaterial(std::string_view name, const Modifier* next, const Spectrum& radiance,
                                   double reach, const Modifier* reflecting)
    : Modifier(name, next),
      Emitter(Kind::glow, radiance),
      traits_(wrapper_traits(name, reflecting)),
      reflecting_(reflecting) {
    reach_ = reach;
}

EmissiveMaterial::EmissiveMaterial(std::string_view name, const Modifier* next, const Spectrum& radiance,
                                   double reach, std::unique_ptr<Modifier> reflecting)
    : EmissiveMaterial(name, next, radiance, reach, reflecting.get()) {
    owned_ = std::move(reflecting);
}

bool EmissiveMaterial::counts(const Tracer& tracer, const Interaction& at) const {
    const Ray& ray = *at.ray;
    const auto out_of_reach = [&](double distance) { return reach_ >= -same_place && distance > reach_; };
    // Sampled as a light source already; a surface that cannot be, in a mixture say, has no source number.
    const bool sampled = tracer.scene().surface(at.surface).source >= 0;
    if (sampled && ray.is(ambient_rays | lobe_rays) && at.cosine >= 0 && !out_of_reach(at.distance))
        return false;
    return tracer.settings().sources_visible || out_of_reach(ray.path_before + at.distance);
}

void EmissiveMaterial::add_emission(Tracer& tracer, Interaction& at) const {
    Spectrum pattern(at.channels());
    emission_pattern(*this, tracer, at, pattern);
    at.radiance.add_product(radiance_, pattern);
}

bool EmissiveMaterial::shade(Tracer& tracer, Interaction& at) const {
    const Ray& ray = *at.ray;
    if (ray.is(shadow_rays)) {
        const bool aimed =
            ray.aimed_source >= 0 && tracer.scene().source(ray.aimed_source).shines_from(at.surface);
        if (!aimed) return !reflecting_ || tracer.shade_chain(reflecting_, at);
        if (at.cosine >= 0) add_emission(tracer, at);
        return true;
    }
    if (at.cosine < 0 && !tracer.settings().back_faces_visible) {
        tracer.pass_through(at);
        return true;
    }
    Spectrum emitted(at.channels());
    if (counts(tracer, at)) {
        add_emission(tracer, at);
        emitted = at.radiance;
        at.radiance.clear();
    } else {
        at.counted_elsewhere = true;
    }
    if (reflecting_) tracer.shade_chain(reflecting_, at);
    at.radiance += emitted;
    return true;
}

std::unique_ptr<Modifier> make_emissive(ModifierContext& context) {
    const auto numbers = context.reals();
    const Modifier* reflecting = wrapped_material(context);
    return std::make_unique<EmissiveMaterial>(context.name(), context.next, context.emission(0),
                                              numbers.size() > 3 ? numbers[3] : 0.0, reflecting);
}

}  // namespace infra
