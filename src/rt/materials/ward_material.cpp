#include "rt/materials/ward_material.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/compile/modifier_table.h"
#include "rt/compile/table_cache.h"
#include "rt/lobes/ward.h"
#include "rt/materials/smoothing.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double fresnel_threshold =
    0.017999;  // smooth surfaces of less specularity show no Fresnel reflection

bool is_rough(const FacetSlopes& roughness) { return roughness.u * roughness.u > tiny; }

void find_energy(ModifierContext& context, WardFacets& facets) {
    if (ward_sample_count(context.settings.specular_samples, 1) > 1)
        facets.energy = context.tables.ward_energy_of(facets.roughness);
}

}  // namespace

std::unique_ptr<Modifier> make_ward_material(ModifierContext& context, WardParameters parameters,
                                             bool transparent) {
    if (is_rough(parameters.facets.roughness)) find_energy(context, parameters.facets);
    return std::make_unique<WardMaterial>(context.name(), context.next, parameters, transparent);
}

std::unique_ptr<Modifier> make_oriented_ward_material(ModifierContext& context, WardParameters parameters,
                                                      bool transparent) {
    const FacetSlopes& roughness = parameters.facets.roughness;
    if (!(roughness.u > tiny && roughness.v > tiny))
        throw context.error("roughness too small", "urough and vrough must be above 0");
    const double mean = std::hypot(roughness.u, roughness.v) / std::numbers::sqrt2;
    WardFacets all_around{{mean, mean}, nullptr};
    find_energy(context, all_around);
    find_energy(context, parameters.facets);
    return std::make_unique<WardMaterial>(
        context.name(), context.next, parameters, transparent,
        std::make_unique<const WardOrientation>(Orientation(context), std::move(all_around)));
}

WardMaterial::WardMaterial(std::string_view name, const Modifier* next, const WardParameters& parameters,
                           bool transparent, std::unique_ptr<const WardOrientation> orientation)
    : SurfaceMaterial(name, next, transparent),
      p_(parameters),
      orientation_(std::move(orientation)),
      smooth_(!orientation_ && !is_rough(p_.facets.roughness)) {
    if (orientation_) block_light();
}

// Straight on, but for a texture, which makes the sheet wavy: for rays from the eye, and with an orientation
// for those of the diffuse calculation too (both as in RADIANCE 6.1).
Vec3 WardMaterial::bent_direction(Tracer& tracer, const Interaction& at, bool shadow) const {
    const Vec3& straight = at.ray->direction;
    if (!at.textured() || shadow || (!orientation_ && at.ray->is(ambient_rays))) return straight;
    if (is_smoothed(tracer, at)) return straight;
    const Vec3 bent = straight - at.perturbation;
    return dot(bent, at.normal) < -tiny ? normalize(bent) : straight;
}

void WardMaterial::set_facets(Tracer& tracer, const Interaction& at, const Vec3& normal,
                              WardSetting& setting) const {
    bool oriented = true;
    if (orientation_)
        oriented = orientation_->direction.frame(tracer, at, normal, setting.frame);
    else
        setting.frame = frame_around(normal);
    const WardFacets& facets = oriented ? p_.facets : orientation_->all_around;
    setting.roughness = facets.roughness;
    setting.energy = at.textured() ? nullptr : facets.energy.get();  // it knows of one normal only
}

void WardMaterial::scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const {
    const RenderSettings& settings = tracer.settings();
    const bool flat = tracer.is_flat(at) && !at.textured();
    const double cosine = std::max(-dot(out.normal, at.ray->direction), 0.001);
    const Spectrum color = p_.color * at.pattern;

    // Shares of the energy
    const bool has_fresnel = smooth_ && p_.specularity >= fresnel_threshold;
    const double fresnel = has_fresnel ? fresnel_approximation(cosine) : 0;
    const double reflected = p_.specularity + fresnel * (1.0 - p_.specularity);
    const double transmitted = p_.transmissivity * (1.0 - reflected);
    const double straight = transmitted * p_.transmitted_specular;
    const double diffuse_through = transmitted - straight;
    const double diffuse = 1.0 - transmitted - reflected;

    // Straight through, all that a shadow ray asks for
    const bool straight_sampled = smooth_ || settings.specular_threshold < straight - tiny;
    if (straight > tiny && smooth_) {
        out.has_through = true;
        out.through_coefficient = color * static_cast<float>(straight);
        out.through_direction = bent_direction(tracer, at, shadow);
        out.as_clear_as_air = straight >= 1.0 - tiny;
        out.seen_through = straight > diffuse_through + diffuse;
    }
    if (shadow) return;

    // Reflection
    const bool reflects = reflected > tiny;
    const bool reflection_sampled = smooth_ || settings.specular_threshold < reflected - tiny;
    Spectrum specular_color(color.channels(), static_cast<float>(reflected));
    if (p_.metallic) {
        specular_color =
            color * static_cast<float>(has_fresnel ? p_.specularity * (1.0 - fresnel) : reflected);
        if (has_fresnel) specular_color += Spectrum(color.channels(), static_cast<float>(fresnel));
    }
    if (reflects && smooth_) {
        out.has_mirror = true;
        out.mirror_coefficient = specular_color;
        out.mirror_direction = at.ray->direction + out.normal * (2.0 * cosine);
        if (at.textured() &&
            dot(out.mirror_direction, at.normal) <= tiny)  // a strong texture must not mirror inwards
            out.mirror_direction = at.ray->direction + at.normal * (2.0 * at.cosine);
        out.image_behind = flat && at.ray->is(ambient_rays);
    }
    if (smooth_ && diffuse <= tiny && diffuse_through <= tiny) {
        out.pure_specular = true;
        return;
    }

    // Lobes: evaluated for light sources always, sampled above the threshold
    if (!smooth_) {
        WardSetting setting{at.ray->direction, {}, at.normal, {}, settings.specular_samples, nullptr};
        set_facets(tracer, at, out.normal, setting);
        if (reflects)
            out.add_lobe<WardReflection>(reflection_sampled, specular_color, setting,
                                         flat ? 1.0 - settings.source_jitter : 0.0);
        if (straight > tiny)
            out.add_lobe<WardTransmission>(straight_sampled, color * static_cast<float>(straight), setting,
                                           bent_direction(tracer, at, shadow));
    }

    // Lambertian parts; a lobe that is not sampled joins them in the indirect calculation
    if (diffuse > tiny) {
        out.diffuse = color * static_cast<float>(diffuse);
        out.ambient = out.diffuse;
        if (!smooth_ && reflects && !reflection_sampled) out.ambient += specular_color;
    }
    if (diffuse_through > tiny) {
        out.diffuse_through = color * static_cast<float>(diffuse_through);
        out.ambient_through = color * static_cast<float>(straight_sampled ? diffuse_through : transmitted);
    }
    out.fresnel_coupled = has_fresnel;
}

}  // namespace infra
