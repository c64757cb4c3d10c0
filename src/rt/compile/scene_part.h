// One of the texts that make up a scene.
#pragma once

#include "scene/scene.h"

namespace infra {

/// The scene itself, an octree that is instanced, or what modifies a mesh. Primitives of all parts are
/// counted through; an octree or mesh is a part once, however often it is placed.
struct ScenePart {
    Scene text;
    PrimitiveId first = 0;  ///< number of its first primitive among those of all parts

    /// Number among those of all parts.
    PrimitiveId number(PrimitiveId own) const { return own == void_primitive ? own : first + own; }
};

}  // namespace infra
