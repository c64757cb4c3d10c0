// Readers of models: Wavefront OBJ, STL (text and binary) and PLY (text and binary), chosen by the file's
// name.
#pragma once

#include <string>

#include "scene/mesh/face_sink.h"

namespace infra {

struct ModelOptions {
    /// Vertices may be forgotten once their face has been handed on, where the format allows it (STL).
    bool forget_vertices = false;
    /// A normal of length 0 is an error, and not kept as (0, 0, 0).
    bool refuse_zero_normals = true;
};

/// How much of a file was understood. Its lines and statements are 0 for a binary one.
struct ModelSummary {
    long long lines = 0;
    long long statements = 0;    ///< of OBJ
    long long unrecognized = 0;  ///< of those
    long long zero_normals = 0;
    int faces = 0;
};

/// Reads a model; "" is standard input, which must be OBJ, as must names that end neither in .stl nor in
/// .ply. `vertices` must be empty; it is the lists of the faces handed on, and holds all of them afterwards.
///   throws  Error "file:line: ..." (for a binary file "file: ...") for missing, malformed and truncated
///   files
ModelSummary read_model(const std::string& path, const ModelOptions& options, VertexLists& vertices,
                        FaceSink& sink);

}  // namespace infra
