// The texture that makes facets look round.
#pragma once

#include "rt/tracer.h"

namespace infra {

/// Whether a surface has RADIANCE's name for that texture as its modifier: it bends no light that goes
/// through.
inline bool is_smoothed(const Tracer& tracer, const Interaction& at) {
    const Modifier* modifier = at.hit() ? tracer.scene().finish(at.surface).modifier : nullptr;
    return modifier && modifier->name() == "Phong";
}

}  // namespace infra
