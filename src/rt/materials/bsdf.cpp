// BSDF and aBSDF: what a measured or computed BSDF file says of reflection and transmission.
//
//     mod BSDF id
//     6+ thickness file.xml ux uy uz funcfile transform
//     0
//     0 | 3 | 6 | 9 diffuse reflectance of the front, of the back, diffuse transmittance
//
//     mod aBSDF id
//     5+ file.xml ux uy uz funcfile transform
//     0
//     0 | 3 | 6 | 9 as above
//
// The file holds Klems matrices or tensor trees (bsdf/bsdf.h). thickness and the up vector are expressions of
// the function file; with the normal, textures included, the up vector lays the file's axes. The numbers add
// to the file's Lambertian parts. Patterns multiply all but the reflection beyond these.
//
// A thickness other than 0 makes the surface stand for geometry behind it (positive) or in front of it
// (negative): rays from the eye and shadow rays go on as if it were not there, as do all that come from the
// other side; what scattered rays find transmitted starts that far behind the surface.
//
// aBSDF, "a" for aperture, looks for a peak of transmission straight on. Rays from the eye and shadow rays
// pass through that, coloured by it but unscattered; scattered rays sample all of the table. source: RADIANCE
// reference manual, "Materials"; measured from RADIANCE 6.1.
#include "bsdf/bsdf.h"

#include <algorithm>
#include <cmath>

#include "common/parse_number.h"
#include "common/raypath.h"
#include "rt/compile/modifier_table.h"
#include "rt/compile/table_cache.h"
#include "rt/functions/functions.h"
#include "rt/lobes/bsdf_lobe.h"
#include "rt/materials/bsdf_aperture.h"
#include "rt/materials/bsdf_response.h"
#include "rt/materials/scattering.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;

/// What the numbers of the primitive add.
struct AddedDiffuse {
    Spectrum front, back, through;
};

class BsdfMaterial final : public Modifier {
  public:
    BsdfMaterial(ModifierContext& context, bool has_aperture, std::shared_ptr<const Bsdf> bsdf,
                 const AddedDiffuse& added);

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

  private:
    struct Geometry {
        double thickness = 0;
        Vec3 up{0};
    };
    Geometry geometry_at(Tracer& tracer, const Interaction& at) const;
    void shade_surface(Tracer& tracer, Interaction& at, BsdfHit& hit, double thickness) const;
    void fill_reflection(const Tracer& tracer, const BsdfHit& hit, const ResolutionRange& resolution,
                         Scattering& out) const;
    void fill_transmission(const Tracer& tracer, const Interaction& at, const BsdfHit& hit,
                           const ResolutionRange& resolution, Scattering& out) const;

    MaterialTraits traits_;
    bool has_aperture_;
    bool is_flat_;  ///< the thickness is 0 in so many words
    std::shared_ptr<const Bsdf> bsdf_;
    AddedDiffuse added_;
    FunctionSet functions_;  ///< up vector, thickness
};

BsdfMaterial::BsdfMaterial(ModifierContext& context, bool has_aperture, std::shared_ptr<const Bsdf> bsdf,
                           const AddedDiffuse& added)
    : Modifier(context.name(), context.next),
      has_aperture_(has_aperture),
      is_flat_(has_aperture),
      bsdf_(std::move(bsdf)),
      added_(added),
      functions_(context, has_aperture ? 1 : 2, 3, has_aperture ? 4 : 5) {
    if (!has_aperture) {
        double thickness = 1;
        is_flat_ = parse_real(context.strings()[0], thickness) && thickness == 0;
        if (!is_flat_) functions_.add_expression(context, 0);
    }
    traits_ = {.name = context.name(),
               .transparent = has_aperture,
               .stands_for_others = !is_flat_,
               .blocks_light = is_flat_ && !has_aperture};
}

BsdfMaterial::Geometry BsdfMaterial::geometry_at(Tracer& tracer, const Interaction& at) const {
    double values[4] = {0, 0, 0, 0};
    if (!functions_.evaluate(tracer, at, values)) return {};
    const double thickness = std::fabs(values[3]) > tiny ? values[3] : 0.0;
    return {functions_.length_in_scene(tracer, at, thickness),
            functions_.to_scene(tracer, at, {values[0], values[1], values[2]})};
}

bool BsdfMaterial::shade(Tracer& tracer, Interaction& at) const {
    const bool front = at.cosine > 0;
    const bool shadow = at.ray->is(shadow_rays);
    if (shadow && traits_.blocks_light) return true;
    if (!front && !tracer.settings().back_faces_visible) {
        tracer.pass_through(at);
        return true;
    }
    const Geometry geometry = geometry_at(tracer, at);
    const bool scattered = at.ray->is(lobe_rays | ambient_rays);
    if (geometry.thickness != 0 && (shadow || !scattered || (geometry.thickness > 0) != front)) {
        tracer.pass_through(at);
        return true;
    }
    if (shadow && (!has_aperture_ || !bsdf_->transmission(front))) return true;

    tracer.apply_patterns(next(), at);
    BsdfHit hit(*bsdf_, tracer.scene().channels(), tracer.random(), tracer.settings().specular_samples);
    hit.front = front;
    hit.pattern = at.pattern;
    if (!hit.orient(at.perturbed_normal(), geometry.up, -at.ray->direction)) return true;
    if (has_aperture_) hit.aperture = find_aperture(hit);
    if (!front) at.flip();
    shade_surface(tracer, at, hit, geometry.thickness);
    return true;
}

void BsdfMaterial::shade_surface(Tracer& tracer, Interaction& at, BsdfHit& hit, double thickness) const {
    Scattering scattering(hit.front ? hit.z : -hit.z, at.channels());
    const bool shadow = at.ray->is(shadow_rays);
    if (hit.aperture.open() && !at.ray->is(lobe_rays | ambient_rays)) {
        scattering.has_through = true;
        scattering.through_coefficient = hit.aperture.through;
        scattering.through_direction = at.ray->direction;
        scattering.seen_through = true;
    }
    if (shadow) {
        tracer.transport(scattering, at);
        return;
    }
    const ResolutionRange resolution = bsdf_->resolution(hit.viewer);
    const RenderSettings& settings = tracer.settings();
    const int samples = std::max(
        1, static_cast<int>(std::min<double>(4 * settings.specular_samples * at.weight + 0.5, most_samples)));
    fill_reflection(tracer, hit, resolution, scattering);
    if (thickness == 0) {
        const BsdfResponse response(hit, samples);
        scattering.response = &response;
        fill_transmission(tracer, at, hit, resolution, scattering);
        tracer.transport(scattering, at);
        return;
    }
    // What is transmitted starts behind the geometry that the surface stands for.
    const BsdfResponse reflection(hit, samples, BsdfResponse::Way::reflection);
    scattering.response = &reflection;
    tracer.transport(scattering, at);
    Scattering beyond(scattering.normal, at.channels());
    const BsdfResponse transmission(hit, samples, BsdfResponse::Way::transmission);
    beyond.response = &transmission;
    fill_transmission(tracer, at, hit, resolution, beyond);
    const Vec3 surface = at.point;
    at.point -= (at.flipped ? -at.normal : at.normal) * thickness;
    tracer.transport(beyond, at);
    at.point = surface;
    if (at.blackbody) at.radiance -= *at.blackbody;  // of which both have emitted what they leave over
}

void BsdfMaterial::fill_reflection(const Tracer& tracer, const BsdfHit& hit,
                                   const ResolutionRange& resolution, Scattering& out) const {
    out.diffuse = hit.spectrum_of(bsdf_->lambertian_reflectance(hit.front));
    out.diffuse += hit.front ? added_.front : added_.back;
    out.diffuse *= hit.pattern;
    out.ambient = out.diffuse;
    const ScatterTable* table = hit.reflection();
    if (!table) return;
    const double total = table->total(hit.jittered_viewer(resolution.largest));
    const Spectrum coefficient(hit.channels.count(), static_cast<float>(total));
    if (total > tracer.settings().specular_threshold + tiny)
        out.add_lobe<BsdfLobe>(true, coefficient, hit, *table, total, resolution.least, false);
    else
        out.ambient += coefficient;
}

void BsdfMaterial::fill_transmission(const Tracer& tracer, const Interaction& at, const BsdfHit& hit,
                                     const ResolutionRange& resolution, Scattering& out) const {
    out.diffuse_through = hit.spectrum_of(bsdf_->lambertian_transmittance(hit.front));
    out.diffuse_through += added_.through;
    out.diffuse_through *= hit.pattern;
    out.ambient_through = out.diffuse_through;
    const ScatterTable* table = hit.transmission();
    if (!table) return;
    const bool seen_through = hit.aperture.open() && !at.ray->is(lobe_rays | ambient_rays);
    const double total = table->total(hit.jittered_viewer(resolution.largest));
    const double scattered = total - (seen_through ? hit.aperture.through.brightness() : 0.0);
    if (scattered > tracer.settings().specular_threshold + tiny)
        out.add_lobe<BsdfLobe>(true, hit.pattern * static_cast<float>(total), hit, *table, total,
                               resolution.least, seen_through);
    else if (scattered > tiny)
        out.ambient_through.add_scaled(hit.pattern, static_cast<float>(scattered));
}

std::shared_ptr<const Bsdf> shared_bsdf(ModifierContext& context, std::string_view name) {
    const auto path = find_library_file(name);
    if (!path)
        throw context.error("cannot find BSDF file \"" + std::string(name) + "\"", "looked for in RAYPATH");
    auto& slot = context.tables.bsdfs[*path];
    if (!slot) {
        LoadedBsdf loaded = load_bsdf(*path);
        context.warnings.insert(context.warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
        slot = std::move(loaded.bsdf);
    }
    return slot;
}

std::unique_ptr<Modifier> make_material(ModifierContext& context, bool has_aperture) {
    const std::size_t given = context.reals().size();
    const auto color = [&](std::size_t first) {
        return given > first ? context.color(first) : Spectrum(context.channels.count());
    };
    auto bsdf = shared_bsdf(context, context.strings()[has_aperture ? 0 : 1]);
    return std::make_unique<BsdfMaterial>(context, has_aperture, std::move(bsdf),
                                          AddedDiffuse{color(0), color(3), color(6)});
}

}  // namespace

std::unique_ptr<Modifier> make_bsdf(ModifierContext& context) { return make_material(context, false); }

std::unique_ptr<Modifier> make_absdf(ModifierContext& context) { return make_material(context, true); }

}  // namespace infra
