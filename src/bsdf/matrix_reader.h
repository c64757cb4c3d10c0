// Klems matrices: WavelengthDataBlocks of a file whose IncidentDataStructure is Columns or Rows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bsdf/scatter_table.h"
#include "bsdf/window_element.h"

namespace infra {

/// Makes a table for each direction that has a Visible block, coloured if CIE-X and CIE-Z are there too.
/// Columns: all incident directions of the first outgoing one come first; Rows: the other way about.
///   throws  Error with file and line for unknown angle bases, wrong numbers of values, what is no number
std::vector<std::unique_ptr<ScatterTable>> read_matrices(const WindowElement& element,
                                                         std::vector<std::string>& warnings);

}  // namespace infra
