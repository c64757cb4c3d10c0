#include "rt/materials/refracting_surface.h"

#include <algorithm>
#include <cmath>

#include "rt/compile/modifier_table.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double most_opaque = 100;  // optical depth of one scene unit of what lets nothing through

float optical_depth(double transmissivity) {
    if (transmissivity >= 1) return 0.0f;
    return static_cast<float>(transmissivity > 0 ? std::min(-std::log(transmissivity), most_opaque)
                                                 : most_opaque);
}

/// Light at a smooth boundary. source: Born & Wolf, Principles of Optics, 1.5.
struct Refraction {
    double ratio;            ///< index before the boundary over that beyond
    double cosine;           ///< of the angle of incidence
    double beyond = 0;       ///< of the angle of refraction
    double reflectance = 1;  ///< for unpolarised light
    bool is_total = true;    ///< nothing passes

    Refraction(double index_ratio, double incidence) : ratio(index_ratio), cosine(incidence) {
        const double squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        if (squared < tiny) return;
        is_total = false;
        beyond = std::sqrt(squared);
        const double along = (cosine - ratio * beyond) / (cosine + ratio * beyond);
        const double across = (beyond - ratio * cosine) / (beyond + ratio * cosine);
        reflectance = 0.5 * (along * along + across * across);
    }

    Vec3 refracted(const Vec3& direction, const Vec3& normal) const {
        return direction * ratio + normal * (ratio * cosine - beyond);
    }
};

void add_through(const Interaction& at, const Refraction& refraction, Scattering& out) {
    const double squeezed = refraction.ratio * refraction.ratio;  // radiance is n^2 times as large within
    out.has_through = true;
    out.radiance_change = static_cast<float>(squeezed);
    out.through_coefficient.fill(static_cast<float>((1.0 - refraction.reflectance) * squeezed));
    out.through_direction = normalize(refraction.refracted(at.ray->direction, out.normal));
    if (at.textured() &&
        dot(out.through_direction, at.normal) >= -tiny)  // a strong texture must not turn it back
        out.through_direction = normalize(refraction.refracted(at.ray->direction, at.normal));
}

void add_mirror(const Interaction& at, const Refraction& refraction, Scattering& out) {
    out.has_mirror = true;
    out.mirror_coefficient.fill(static_cast<float>(refraction.reflectance));
    out.mirror_direction = at.ray->direction + out.normal * (2.0 * refraction.cosine);
    if (at.textured() && dot(out.mirror_direction, at.normal) <= tiny)
        out.mirror_direction = at.ray->direction + at.normal * (2.0 * at.cosine);
}

}  // namespace

ClearBody::ClearBody(const ModifierContext& context, std::size_t first)
    : transmissivity(context.color(first)), index(context.reals()[first + 3]) {
    if (!(index > 0)) throw context.error("refractive index must be above 0");
}

Medium ClearBody::medium(const Spectrum& pattern, const Medium* before) const {
    Medium medium(pattern.channels());
    for (int c = 0; c < pattern.channels(); ++c)
        medium.extinction.set(c, optical_depth(static_cast<double>(transmissivity[c]) * double(pattern[c])));
    if (before) medium.sources = before->sources;
    return medium;
}

RefractingSurface::RefractingSurface(ModifierContext& context, ClearBody inside,
                                     std::optional<ClearBody> outside)
    : Modifier(context.name(), context.next),
      traits_{.name = context.name(), .transparent = true},
      inside_(std::move(inside)),
      outside_(std::move(outside)) {}

bool RefractingSurface::shade(Tracer& tracer, Interaction& at) const {
    if (tracer.is_in_photon_map(*at.ray)) return true;
    tracer.apply_patterns(next(), at);
    const bool from_inside = at.cosine < 0;
    if (from_inside) at.flip();

    // Each crossing says anew what is before it and what beyond.
    const ClearBody* const outer = outside_ ? &*outside_ : nullptr;
    const ClearBody* const here = from_inside ? &inside_ : outer;
    const ClearBody* const there = from_inside ? outer : &inside_;
    if (here) at.has_travelled_in(here->medium(at.pattern, at.medium));
    Medium beyond = there ? there->medium(at.pattern, at.medium) : tracer.scene().surroundings();
    if (!there && at.medium) beyond.sources = at.medium->sources;

    Scattering out(at.perturbed_normal(), at.channels());
    const double index = inside_.index / index_outside();
    const Refraction refraction(from_inside ? index : 1.0 / index,
                                std::max(-dot(out.normal, at.ray->direction), tiny));
    const bool shadow = at.ray->is(shadow_rays);
    const bool smooth = tracer.is_flat(at) && (!at.textured() || at.ray->is(ambient_rays));
    if (!refraction.is_total) {
        add_through(at, refraction, out);
        out.changes_medium = true;
        out.medium_beyond = beyond.matters() ? &beyond : nullptr;
        out.seen_through = smooth || std::fabs(refraction.ratio - 1.0) <= tiny;
    }
    if (!shadow) add_mirror(at, refraction, out);
    out.image_behind = smooth;
    out.pure_specular = true;
    tracer.transport(out, at);
    if (from_inside) at.flip();  // the surface is reported as it stands
    return true;
}

}  // namespace infra
