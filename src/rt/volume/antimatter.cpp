// antimatter: a body that takes its volume out of others.
//
//     mod antimatter id
//     N mod1 mod2 .. modN
//     0
//     0
//
// A ray that enters it no longer meets surfaces of the listed modifiers until it leaves. If it leaves within
// a body of one of them, there is the face of the cut: the antimatter's surface shaded as mod1, seen from
// outside the body. With void as mod1 nothing is there. Whether the ray is within a body is counted along its
// path, so bodies have to be closed, with normals outward, and the eye outside. source: RADIANCE reference
// manual, "Antimatter".
#include "rt/volume/antimatter.h"

#include <algorithm>

#include "rt/tracer.h"
#include "rt/volume/cut.h"

namespace infra {

Antimatter::Antimatter(ModifierContext& context)
    : Modifier(context.name(), context.next), traits_{.name = context.name(), .is_mixture = true} {
    const auto names = context.strings();
    const auto warn = [&](std::string_view what, std::string_view name) {
        const std::string text = std::string(what) + " \"" + std::string(name) + "\"";
        context.warnings.push_back(context.error(text, "antimatter cuts the modifiers it names").what());
    };
    for (const std::string_view name : names) {
        if (name == "void") continue;
        const PrimitiveId modifier = context.scene.find_modifier_before(name, context.id);
        if (modifier == void_primitive)
            warn("unknown modifier", name);
        else if (std::find(modifiers_.begin(), modifiers_.end(), context.first_number + modifier) !=
                 modifiers_.end())
            warn("duplicate modifier", name);
        else
            modifiers_.push_back(context.first_number + modifier);
    }
    std::sort(modifiers_.begin(), modifiers_.end());
    shows_cut_ =
        names[0] != "void" && context.scene.find_modifier_before(names[0], context.id) != void_primitive;
    if (shows_cut_) shading_ = context.modifier_named(names[0]);
}

bool Antimatter::shade(Tracer& tracer, Interaction& at) const {
    const Cut cut{at.ray->cut, modifiers_, at.cosine > 0};
    at.cut_beyond = &cut;
    bool shaded = false;
    if (shows_cut_ && is_inside_body(tracer, at)) {
        at.flip();
        shaded = tracer.shade_chain(shading_, at);
    }
    if (!shaded) tracer.pass_through(at);
    at.cut_beyond = at.ray->cut;
    return true;
}

// Counts how often the path has gone into and come out of the bodies.
bool Antimatter::is_inside_body(const Tracer& tracer, const Interaction& at) const {
    int depth = 0;
    for (const Ray* ray = at.ray; ray->parent; ray = ray->parent->ray) {
        const Interaction& crossed = *ray->parent;
        if (ray->kind & turning_rays || !crossed.hit()) continue;
        const PrimitiveId modifier = tracer.scene().finish(crossed.surface).primitive;
        if (!std::binary_search(modifiers_.begin(), modifiers_.end(), modifier)) continue;
        const bool from_front = (crossed.cosine > 0) != crossed.flipped;
        depth += from_front ? 1 : -1;
    }
    return depth > 0;
}

std::unique_ptr<Modifier> make_antimatter(ModifierContext& context) {
    return std::make_unique<Antimatter>(context);
}

}  // namespace infra
