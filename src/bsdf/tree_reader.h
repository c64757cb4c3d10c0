// Tensor trees: WavelengthDataBlocks of a file whose IncidentDataStructure is TensorTree3 or TensorTree4.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bsdf/scatter_table.h"
#include "bsdf/window_element.h"

namespace infra {

/// Makes a table for each direction that has a Visible block, coloured if CIE-u and CIE-v are there too.
///   throws  Error with file and line for another angle basis than LBNL/Shirley-Chiu and what
///           parse_tensor_tree() refuses
std::vector<std::unique_ptr<ScatterTable>> read_trees(const WindowElement& element,
                                                      std::vector<std::string>& warnings);

}  // namespace infra
