#include "rt/mixtures/mixture.h"

#include <algorithm>

#include "rt/compile/modifier_table.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double negligible = 1e-6;  // a share below it is not traced

bool shade_part(Tracer& tracer, Interaction& part, const Modifier* chain, double share) {
    if (share <= negligible) return false;
    part.weight *= share;
    part.share *= share;
    return tracer.shade_chain(chain, part);
}

void mix(Spectrum& result, const Spectrum& a, double share, const Spectrum& b) {
    result = a * static_cast<float>(share);
    result.add_scaled(b, static_cast<float>(1.0 - share));
}

}  // namespace

Mixture::Mixture(ModifierContext& context)
    : Modifier(context.name(), context.next),
      traits_{.name = context.name(), .is_mixture = true},
      foreground_(context.modifier_named(context.strings()[0])),
      background_(context.modifier_named(context.strings()[1])),
      mixes_materials_(material_of(foreground_) || material_of(background_)) {
    for (const Modifier* part : {foreground_, background_})
        if (const Modifier* material = material_of(part); material && material->traits()->emits)
            traits_.emits = true;
    if (context.next && mixes_materials_)
        throw context.error("inappropriate modifier on a mixture of materials",
                            "modify the materials instead");
}

bool Blend::shade(Tracer& tracer, Interaction& at) const {
    double share;
    if (!foreground_share(tracer, at, share)) return false;
    share = std::clamp(share, 0.0, 1.0);

    Interaction fore = at, back = at;
    SkyView fore_sky(at.sky ? at.channels() : 1), back_sky = fore_sky;
    if (at.sky) {
        fore.sky = &fore_sky;
        back.sky = &back_sky;
    }
    const bool fore_material = shade_part(tracer, fore, foreground(), share);
    const bool back_material = shade_part(tracer, back, background(), 1.0 - share);
    if (back_material && !fore_material && share > negligible) tracer.pass_through(fore);
    if (fore_material && !back_material && 1.0 - share > negligible) tracer.pass_through(back);

    mix(at.pattern, fore.pattern, share, back.pattern);
    at.perturbation = fore.perturbation * share + back.perturbation * (1.0 - share);
    if (!fore_material && !back_material) return false;

    mix(at.radiance, fore.radiance, share, back.radiance);
    mix(at.mirrored, fore.mirrored, share, back.mirrored);
    if (at.sky) {
        mix(at.sky->radiance, fore_sky.radiance, share, back_sky.radiance);
        mix(at.sky->share, fore_sky.share, share, back_sky.share);
    }
    const double fore_mirrored = share * fore.mirrored.brightness();
    const double back_mirrored = (1.0 - share) * back.mirrored.brightness();
    at.mirrored_distance = fore_mirrored > back_mirrored ? fore.mirrored_distance : back.mirrored_distance;
    at.direct_distance = share * fore.radiance.brightness() - fore_mirrored >
                                 (1.0 - share) * back.radiance.brightness() - back_mirrored
                             ? fore.direct_distance
                             : back.direct_distance;
    return true;
}

}  // namespace infra
