// A mesh in figures, for people.
#pragma once

#include <string>

#include "scene/mesh/mesh_writer.h"

namespace infra {

/// Some lines of text: how many patches, vertices, triangles and cells.
std::string describe(const PackedMesh& mesh);

}  // namespace infra
