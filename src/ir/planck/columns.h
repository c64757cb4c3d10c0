// One column of a text table converted, the rest left as it is.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace infra::ir {

/// The text with the number in one column of every line replaced by convert(number), written by %.9g. Columns
/// are separated by blanks or tabs, which stay; so do empty lines and lines that begin with '#'.
///   column  from 1
///   name    of the text, for messages
///   throws  Error with the line for a missing column or no number; what convert throws gets the line too
std::string convert_column(std::string_view text, int column, const std::function<double(double)>& convert,
                           const std::string& name);

}  // namespace infra::ir
