// light, glow, spotlight and illum: surfaces that give light and reflect none.
//
//     mod light id          0 0 3 red green blue
//     mod glow id           0 0 4 red green blue maxrad
//     mod spotlight id      0 0 7 red green blue angle xdir ydir zdir
//     mod illum id          1 material (or 0) 0 3 red green blue
//
// Radiance is given in the scene's unit and seen from the front only. A glow lights what is nearer than
// maxrad; with 0 it is never sampled but found by indirect rays, with a negative one it is only seen. An
// illum looks like another material (or like nothing) unless it is aimed at as a source. source: RADIANCE
// reference manual, "Materials".
#include <cmath>
#include <numbers>

#include "rt/compile/modifier_table.h"
#include "rt/materials/light_material.h"
#include "rt/photons/photon_maps.h"
#include "rt/tracer.h"

namespace infra {

bool LightMaterial::reaches(double distance) const {
    return !(kind_ == Kind::glow && reach_ >= -same_place && distance > reach_);
}

bool LightMaterial::counts(const Tracer& tracer, const Interaction& at) const {
    const Ray& ray = *at.ray;
    // A source that is sampled directly must not be counted again by indirect rays that run into its front.
    if (ray.is(ambient_rays | lobe_rays) && !ray.is(shadow_rays) && at.cosine >= 0 && reaches(at.distance))
        return false;
    // Nor what has come through something, where photons stand for that.
    const PhotonMaps* const photons = tracer.scene().photons();
    if (photons && photons->cover_transmitted_light() && ray.kind == through_ray &&
        ray.is(ambient_rays | shadow_rays))
        return false;
    if (ray.aimed_source < 0) return true;
    const LightSource& aimed = tracer.scene().source(ray.aimed_source);
    if (aimed.surface == at.surface) return true;
    // Another source in the way of the one aimed at blocks it, but an illum is only a window...
    if (kind_ != Kind::illum) return false;
    // ...except towards glows and illums, which it may stand for.
    return !(at.cosine > 0 && aimed.is_weak);
}

bool LightMaterial::shade(Tracer& tracer, Interaction& at) const {
    const Ray& ray = *at.ray;
    if (!counts(tracer, at)) {
        at.counted_elsewhere = true;
        return true;
    }
    const bool aimed =
        ray.aimed_source >= 0 && tracer.scene().source(ray.aimed_source).shines_from(at.surface);
    if (kind_ == Kind::illum && !aimed) {
        if (has_other_) return tracer.shade_chain(other_, at);
        tracer.pass_through(at);
        return true;
    }
    if (!tracer.settings().sources_visible && !ray.is(shadow_rays) &&
        reaches(ray.path_before + at.distance)) {
        at.counted_elsewhere = true;
        return true;
    }
    if (at.cosine < 0) {
        if (!tracer.settings().back_faces_visible) tracer.pass_through(at);
        return true;
    }
    if (kind_ == Kind::spotlight && beam_.misses(ray.direction)) return true;
    tracer.apply_patterns(next(), at);
    at.radiance = radiance_ * at.pattern;
    return true;
}

bool SpotBeam::misses(const Vec3& direction) const {
    return solid_angle < 2 * std::numbers::pi * (1.0 + dot(axis, direction));
}

std::unique_ptr<Modifier> make_light(ModifierContext& context) {
    return std::make_unique<LightMaterial>(LightMaterial::Kind::light, context);
}

std::unique_ptr<Modifier> make_glow(ModifierContext& context) {
    auto glow = std::make_unique<LightMaterial>(LightMaterial::Kind::glow, context);
    glow->set_reach(context.reals()[3]);
    return glow;
}

std::unique_ptr<Modifier> make_spotlight(ModifierContext& context) {
    const auto numbers = context.reals();
    SpotBeam beam;
    const Vec3 axis{numbers[4], numbers[5], numbers[6]};
    beam.focal_length = length(axis);
    if (!(beam.focal_length > 0)) throw context.error("spotlight direction is zero");
    if (numbers[3] <= 0) throw context.error("spotlight angle must be above 0 degrees");
    beam.axis = axis / beam.focal_length;
    beam.solid_angle = 2 * std::numbers::pi * (1.0 - std::cos(numbers[3] * std::numbers::pi / 360.0));
    auto light = std::make_unique<LightMaterial>(LightMaterial::Kind::spotlight, context);
    light->set_beam(beam);
    return light;
}

std::unique_ptr<Modifier> make_illum(ModifierContext& context) {
    auto illum = std::make_unique<LightMaterial>(LightMaterial::Kind::illum, context);
    if (!context.strings().empty() && context.strings()[0] != "void")
        illum->set_other(context.modifier_named(context.strings()[0]));
    return illum;
}

}  // namespace infra
