// Two chains of modifiers seen in one place, each with its share.
#pragma once

#include "rt/modifier.h"

namespace infra {

/// Shades both chains and mixes their patterns and radiances; share (0..1) is the foreground's. Where only
/// one of them has a material the other lets the ray pass. Answers whether there was a material.
bool shade_mixture(Tracer& tracer, Interaction& at, const Modifier* foreground, const Modifier* background,
                   double share);

}  // namespace infra
