// The text of a tensor tree: { eight or sixteen such } or { values of a grid }.
#pragma once

#include "bsdf/data_numbers.h"
#include "bsdf/tensor_tree.h"

namespace infra {

/// Reads a tree of rank 3 or 4 and all that follows it, which must be nothing.
///   throws  Error with the line for braces that do not match, grids that are not 2^k cells along each side,
///           trees that are too deep, what is no number
TensorTree parse_tensor_tree(DataNumbers& text, int rank);

}  // namespace infra
