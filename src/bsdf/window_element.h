// The XML of a BSDF file, a WindowElement of LBNL's WINDOW and of genBSDF, as text in its parts. What the
// numbers mean is for matrix_reader.h and tree_reader.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bsdf/angle_basis.h"
#include "bsdf/scatter_table.h"
#include "common/error.h"

namespace infra {

/// What the file says of the thing itself; lengths in metres, 0 where they are not told.
struct BsdfDescription {
    std::string material, manufacturer;
    double width = 0, height = 0, thickness = 0;
    std::string geometry;      ///< its shape in MGF, empty if it is not there
    double geometry_unit = 1;  ///< of its lengths, in metres
};

/// One WavelengthDataBlock of a direction that we know.
struct ScatteringBlock {
    Location place;
    std::string wavelength;  ///< "Visible", "CIE-X"...
    ScatterSides sides;
    std::string column_basis, row_basis;  ///< of matrices: of the incident and the outgoing directions
    std::string tree_basis;
    std::string data;
    Location data_place;  ///< where the data begin
};

struct WindowElement {
    Location place;
    BsdfDescription description;
    std::string data_structure;  ///< "Columns", "Rows", "TensorTree3", "TensorTree4"
    Location structure_place;
    std::vector<AngleBasis> bases;  ///< that the file defines and the standard has not
    std::vector<ScatteringBlock> blocks;
};

/// Reads the first layer of a file's optical data.
///   throws  Error with file and line for XML that is not well formed or no such element, for negative or
///   unknown lengths, bad angle bases, and a file without data
WindowElement read_window_element(const std::string& path);
/// The same from text in memory; `name` stands for the file in errors.
WindowElement parse_window_element(std::string_view text, const std::string& name);

}  // namespace infra
