// The readers behind model_reader.h. `name` is for messages; the stream stays the caller's.
#pragma once

#include <cstdio>
#include <string>

#include "scene/mesh/model_reader.h"

namespace infra {

/// Statements v vt vn f g o usemtl usemap, with RADIANCE's meaning; others are counted and ignored. Of a v,
/// what follows x y z is ignored.
ModelSummary read_obj(std::FILE* file, const std::string& name, const ModelOptions& options,
                      VertexLists& vertices, FaceSink& sink);

/// Facets; their normals are ignored, for they follow from the corners. The name of a solid is its object's.
ModelSummary read_stl(std::FILE* file, const std::string& name, const ModelOptions& options,
                      VertexLists& vertices, FaceSink& sink);

/// Elements vertex (x y z, nx ny nz, and u v, s t or texture_u texture_v) and face (vertex_indices or
/// vertex_index); others are skipped.
ModelSummary read_ply(std::FILE* file, const std::string& name, const ModelOptions& options,
                      VertexLists& vertices, FaceSink& sink);

}  // namespace infra
