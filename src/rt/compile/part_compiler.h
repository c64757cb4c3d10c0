// From the primitives of one part of a scene to surfaces, modifiers and shapes.
#pragma once

#include "rt/compile/compile_context.h"

namespace infra {

/// The surfaces of a part: they stand together in the table.
struct SurfaceRange {
    int begin = 0;
    int end = 0;
};

/// Lists what is no modifier: surfaces, volumes and instances.
SurfaceRange add_surfaces(CompileContext& context, const ScenePart& part);

/// Compiles the modifiers that these surfaces use, and only those, so that a library of materials costs
/// nothing and its unused parts may be incomplete, as in RADIANCE.
void finish_surfaces(CompileContext& context, const ScenePart& part, SurfaceRange range);

/// Adds the shapes of all but instances, meshes and distant sources.
///   throws  Error for a wrong number of arguments, also of those
void add_shapes(const CompileContext& context, const ScenePart& part, SurfaceRange range, Geometry& geometry);

}  // namespace infra
