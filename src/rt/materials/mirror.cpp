// mirror: a perfect mirror that light sources are seen in.
//
//     mod mirror id
//     0 | 1 material
//     0
//     3 red green blue
//
// Reflects `red green blue` (times its patterns) from the front; the back is black. Each flat surface of it,
// polygon or ring, makes an image of every light source, which is then sampled like the source itself
// (sources/virtual_sources.cpp). With a material other surfaces see that one instead, or nothing if it is
// void, and only light takes the mirror. source: RADIANCE reference manual, "Materials"; RADIANCE 6.1 as
// measured for what indirect rays see: the mirror, unless the material is a transparent one.
#include "rt/compile/modifier_table.h"
#include "rt/materials/scattering.h"
#include "rt/materials/wrapper.h"
#include "rt/sources/light_relay.h"
#include "rt/tracer.h"

namespace infra {
namespace {

class Mirror final : public Modifier, public LightRelay {
  public:
    Mirror(ModifierContext& context, bool has_other, const Modifier* other)
        : Modifier(context.name(), context.next),
          traits_{.name = context.name(), .relay = this},
          color_(context.color(0)),
          has_other_(has_other),
          other_(other) {
        if (const Modifier* material = material_of(other)) {
            traits_.emits = material->traits()->emits;
            other_is_transparent_ = material->traits()->transparent;
        }
    }

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

    int image_count() const override { return 1; }
    bool project(Tracer&, const RelaySurface& surface, const LightSource& source, int,
                 Projection& image) const override;

  private:
    bool shows_other(const Interaction& at) const;

    MaterialTraits traits_;
    Spectrum color_;
    bool has_other_;
    const Modifier* other_;  ///< nullptr: void
    bool other_is_transparent_ = false;
};

// Indirect rays take the mirror, because they would otherwise miss or count twice what it sends on.
bool Mirror::shows_other(const Interaction& at) const {
    return has_other_ && (at.cosine < 0 || other_is_transparent_ || !at.ray->is(ambient_rays | lobe_rays));
}

bool Mirror::shade(Tracer& tracer, Interaction& at) const {
    const LightSource* image = image_aimed_at(tracer, at);
    if (!image && shows_other(at)) {
        if (other_) return tracer.shade_chain(other_, at);
        tracer.pass_through(at);
        return true;
    }
    if (!image && at.ray->aimed_source >= 0) return true;  // in the way of another source
    const bool front = at.cosine >= 0;
    if (!front && !tracer.settings().back_faces_visible) {
        tracer.pass_through(at);
        return true;
    }
    Scattering scattering(at.normal, at.channels());
    scattering.pure_specular = true;
    if (front) {
        tracer.apply_patterns(next(), at);
        const bool bumpy = at.textured() && !image && !at.ray->is(ambient_rays);
        scattering.has_mirror = true;
        scattering.mirror_coefficient = color_ * at.pattern;
        scattering.mirror_direction = at.ray->direction + at.normal * (2.0 * at.cosine);
        if (bumpy) {
            const Vec3 normal = at.perturbed_normal();
            const Vec3 bent = at.ray->direction - normal * (2.0 * dot(normal, at.ray->direction));
            if (dot(bent, at.normal) > same_place) scattering.mirror_direction = bent;
        }
        scattering.image_behind = !bumpy && tracer.is_flat(at);
        if (image) scattering.relayed_source = image->parent;
    }
    tracer.transport(scattering, at);
    return true;
}

// None of a source that stands behind the mirror as a whole.
bool Mirror::project(Tracer&, const RelaySurface& surface, const LightSource& source, int,
                     Projection& image) const {
    double height = dot(surface.normal, source.center) - (source.distant() ? 0.0 : surface.offset);
    // The axes of round sources are those of a square or cube of samples.
    constexpr double disk = 1.1283791670955126, ball = 1 / 0.7236;
    const double widen = !source.round ? 1.0 : source.extent == LightSource::Extent::sphere ? ball : disk;
    for (const Vec3& axis : source.half_axis) height += widen * std::fabs(dot(surface.normal, axis));
    if (height <= same_place) return false;
    image = {surface.normal, surface.offset, surface.normal * -2.0, true};
    return true;
}

}  // namespace

std::unique_ptr<Modifier> make_mirror(ModifierContext& context) {
    return std::make_unique<Mirror>(context, !context.strings().empty(), wrapped_material(context));
}

}  // namespace infra
