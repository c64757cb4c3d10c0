// What emissive and thermal share: they emit, and another material does the reflecting.
#pragma once

#include "rt/compile/modifier_table.h"

namespace infra {

/// Traits of a wrapper around a chain: those of its material, opaque if there is none.
MaterialTraits wrapper_traits(std::string_view name, const Modifier* reflecting);

/// The chain that the first string argument names, nullptr for void or none.
/// throws Error for a name that is no material
const Modifier* wrapped_material(const ModifierContext& context);

/// Shades the patterns on a wrapper by themselves: what modifies its emission does not modify the material.
/// The result stands in `pattern`; it starts from the hit's, which is 1 unless a pattern came before the
/// wrapper.
void emission_pattern(const Modifier& wrapper, Tracer& tracer, Interaction& at, Spectrum& pattern);

}  // namespace infra
