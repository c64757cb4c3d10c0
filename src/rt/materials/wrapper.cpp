#include "rt/materials/wrapper.h"

#include "rt/tracer.h"

namespace infra {

MaterialTraits wrapper_traits(std::string_view name, const Modifier* reflecting) {
    const Modifier* material = Modifier::material_of(reflecting);
    MaterialTraits traits{.name = name, .blocks_light = true, .emits = true};
    if (material) {
        traits.transparent = material->traits()->transparent;
        traits.stands_for_others = material->traits()->stands_for_others;
        traits.blocks_light = material->traits()->blocks_light;
        traits.relay = material->traits()->relay;
    }
    return traits;
}

const Modifier* wrapped_material(const ModifierContext& context) {
    const auto strings = context.strings();
    const Modifier* reflecting = strings.empty() ? nullptr : context.modifier_named(strings[0]);
    if (reflecting && !Modifier::material_of(reflecting))
        throw context.error("\"" + std::string(strings[0]) + "\" is not a material",
                            "name a material, or void");
    return reflecting;
}

void emission_pattern(const Modifier& wrapper, Tracer& tracer, Interaction& at, Spectrum& pattern) {
    pattern = at.pattern;
    if (!wrapper.next()) return;
    const Spectrum before = at.pattern;
    const Vec3 perturbation = at.perturbation;
    tracer.apply_patterns(wrapper.next(), at);
    pattern = at.pattern;
    at.pattern = before;
    at.perturbation = perturbation;
}

}  // namespace infra
