// Readers of measured samples as text. In both formats `#` starts a comment to the end of the line, words are
// separated by blanks, tabs or commas, angles are degrees and values f in 1/sr.
//
// Columns: the first line names the columns, each later line is a sample.
//
//     theta_i phi_i theta_r phi_r value      or     theta_i phi theta_r value, in any order
//     20      0     35      180   0.412
//
// Cuts, as a goniometer scans them: for every incident angle a table whose columns are azimuths.
//
//     theta_i 20
//     theta_r  0     90    180
//     0        0.31  0.31  0.31
//     10       0.28  0.30  -                 "-" is a direction that was not measured
//     theta_i 40
//     ...
#pragma once

#include <string>
#include <string_view>

#include "ir/brdftab/sample.h"

namespace infra::ir {

/// Parse a text; `name` stands for the file in errors.
///   throws  Error with file and line: a column missing, unknown or given twice, a wrong number of words,
///   what
///           is no number, NaN, theta outside 0..90 deg, phi outside -360..360 deg, a negative value, no
///           samples
SampleSet parse_columns(std::string_view text, const std::string& name, const SampleRules& rules = {});
SampleSet parse_cuts(std::string_view text, const std::string& name, const SampleRules& rules = {});

}  // namespace infra::ir
