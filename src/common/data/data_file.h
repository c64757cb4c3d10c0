// RADIANCE's data files: tables of numbers over any number of coordinates. Written by ies2rad, by users'
// scripts and by hand; read here for brightdata, colordata, specdata and their kin.
//
//     # comment, to the end of the line
//     2                    number of dimensions
//     0 90 10              a dimension of 10 places, evenly from 0 to 90
//     0 0 4  380 480 600 780      one of 4 places that follow, rising or falling
//     values, those of the last dimension next to each other
//
// Values are kept in single precision.
#pragma once

#include <string>
#include <string_view>

#include "common/data/data_table.h"

namespace infra {

/// Reads a file.
///   throws  Error with file and line for what is no number, counts that don't fit the values, places out of
///           order, an empty file
DataTable read_data_file(const std::string& path);

/// The same from a text; `name` stands for the file in errors.
DataTable parse_data(std::string_view text, const std::string& name);

}  // namespace infra
