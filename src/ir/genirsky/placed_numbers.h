// Numbers of a text file that know where they stand, so that whoever finds one wrong can name its place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"

namespace infra::ir {

struct PlacedNumber {
    double value = 0;
    int line = 0;    ///< from 1
    int column = 0;  ///< of its first character, from 1
};

using NumberLine = std::vector<PlacedNumber>;

/// A file's numbers, line by line; lines without any are left out.
struct NumberText {
    std::string name;  ///< of the file, for messages
    std::vector<NumberLine> lines;
    int last_line = 1;  ///< where the text ends

    Location place(const PlacedNumber& number) const { return {name, number.line, number.column}; }
    Location end() const { return {name, last_line}; }
    /// All numbers in the order of the file.
    std::vector<PlacedNumber> all() const;
};

/// Words are separated by blanks, tabs or commas; '#' starts a comment.
/// throws Error with line and column for a word that is no finite number, and for a text without numbers.
NumberText parse_numbers(std::string_view text, const std::string& name);

/// parse_numbers() of a file, "-" being the standard input.
NumberText read_numbers(const std::string& path);

/// How messages call a file.
std::string shown_name(const std::string& path);

}  // namespace infra::ir
