#include "rt/materials/ward_material.h"

#include <algorithm>

#include "rt/compile/modifier_table.h"
#include "rt/compile/table_cache.h"
#include "rt/lobes/ward.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double fresnel_threshold =
    0.017999;  // smooth surfaces of less specularity show no Fresnel reflection

/// Straight on, but for a texture, which makes the sheet wavy for rays from the eye.
Vec3 bent_direction(const Interaction& at, bool shadow) {
    const Vec3& straight = at.ray->direction;
    if (!at.textured() || shadow || at.ray->is(ambient_rays)) return straight;
    const Vec3 bent = straight - at.perturbation;
    return dot(bent, at.normal) < -tiny ? normalize(bent) : straight;
}

}  // namespace

std::unique_ptr<Modifier> make_ward_material(ModifierContext& context, WardParameters parameters,
                                             bool transparent) {
    const bool rough = parameters.roughness * parameters.roughness > tiny;
    if (rough && ward_sample_count(context.settings.specular_samples, 1) > 1)
        parameters.energy = context.tables.ward_energy_of(parameters.roughness);
    return std::make_unique<WardMaterial>(context.name(), context.next, parameters, transparent);
}

void WardMaterial::scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const {
    const RenderSettings& settings = tracer.settings();
    const bool flat_surface = tracer.is_flat(at);
    const bool textured = at.textured();
    const double cosine = std::max(-dot(out.normal, at.ray->direction), 0.001);
    const bool smooth = p_.roughness * p_.roughness <= tiny;
    const Spectrum color = p_.color * at.pattern;

    // Shares of the energy
    const bool has_fresnel = smooth && p_.specularity >= fresnel_threshold;
    const double fresnel = has_fresnel ? fresnel_approximation(cosine) : 0;
    const double reflected = p_.specularity + fresnel * (1.0 - p_.specularity);
    const double transmitted = p_.transmissivity * (1.0 - reflected);
    const double straight = transmitted * p_.transmitted_specular;
    const double diffuse_through = transmitted - straight;
    const double diffuse = 1.0 - transmitted - reflected;

    // Straight through, all that a shadow ray asks for
    const bool straight_sampled = smooth || settings.specular_threshold < straight - tiny;
    if (straight > tiny && smooth) {
        out.has_through = true;
        out.through_coefficient = color * static_cast<float>(straight);
        out.through_direction = bent_direction(at, shadow);
        out.as_clear_as_air = straight >= 1.0 - tiny;
        out.seen_through = straight > diffuse_through + diffuse;
    }
    if (shadow) return;

    // Reflection
    const bool reflects = reflected > tiny;
    const bool reflection_sampled = smooth || settings.specular_threshold < reflected - tiny;
    Spectrum specular_color(color.channels(), static_cast<float>(reflected));
    if (p_.metallic) {
        specular_color =
            color * static_cast<float>(has_fresnel ? p_.specularity * (1.0 - fresnel) : reflected);
        if (has_fresnel) specular_color += Spectrum(color.channels(), static_cast<float>(fresnel));
    }
    if (reflects && smooth) {
        out.has_mirror = true;
        out.mirror_coefficient = specular_color;
        out.mirror_direction = at.ray->direction + out.normal * (2.0 * cosine);
        if (textured &&
            dot(out.mirror_direction, at.normal) <= tiny)  // a strong texture must not mirror inwards
            out.mirror_direction = at.ray->direction + at.normal * (2.0 * at.cosine);
        out.image_behind = flat_surface && !textured && at.ray->is(ambient_rays);
    }
    if (smooth && diffuse <= tiny && diffuse_through <= tiny) {
        out.pure_specular = true;
        return;
    }

    // Lobes: evaluated for light sources always, sampled above the threshold
    if (!smooth) {
        const WardSetting setting{
            at.ray->direction,         out.normal,     at.normal, p_.roughness * p_.roughness,
            settings.specular_samples, p_.energy.get()};
        if (reflects)
            out.add_lobe<WardReflection>(reflection_sampled, specular_color, setting,
                                         flat_surface && !textured ? 1.0 - settings.source_jitter : 0.0);
        if (straight > tiny)
            out.add_lobe<WardTransmission>(straight_sampled, color * static_cast<float>(straight), setting,
                                           bent_direction(at, shadow));
    }

    // Lambertian parts; a lobe that is not sampled joins them in the indirect calculation
    if (diffuse > tiny) {
        out.diffuse = color * static_cast<float>(diffuse);
        out.ambient = out.diffuse;
        if (!smooth && reflects && !reflection_sampled) out.ambient += specular_color;
    }
    if (diffuse_through > tiny) {
        out.diffuse_through = color * static_cast<float>(diffuse_through);
        out.ambient_through = color * static_cast<float>(straight_sampled ? diffuse_through : transmitted);
    }
    out.fresnel_coupled = has_fresnel;
}

}  // namespace infra
