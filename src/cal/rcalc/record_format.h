// Templates of records: literal text with ${numeric} and $(string) fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cal/program.h"

namespace infra::rcalc {

struct Field {
    enum class Kind { literal, string, number };

    Kind kind = Kind::literal;
    std::string text;        ///< literal text, name of a variable, or expression
    int width = 0;           ///< characters the field takes in the template, with its $ and brackets
    cal::ExprId expression;  ///< of a number in an output template
};

using RecordFormat = std::vector<Field>;

/// Fields of a template: of `specification` itself if there is a '$' in it, else of the file that it names.
/// A newline is added at the end unless there is one or newlines are ignored.
///   throws Error for a '$' that starts no field, a field that is not closed, a file that is missing or empty
RecordFormat read_record_format(std::string_view specification, bool ignore_newlines);

}  // namespace infra::rcalc
