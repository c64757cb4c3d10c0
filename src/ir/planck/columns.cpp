#include "ir/planck/columns.h"

#include <algorithm>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"

namespace infra::ir {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The column's place in the line, and an empty view at its end where the line has fewer columns.
std::string_view find_column(std::string_view line, int column) {
    std::size_t start = std::min(line.find_first_not_of(blanks), line.size());
    for (int passed = 1;; ++passed) {
        const std::size_t end = std::min(line.find_first_of(blanks, start), line.size());
        if (passed == column || start == line.size()) return line.substr(start, end - start);
        start = std::min(line.find_first_not_of(blanks, end), line.size());
    }
}

double number_in(std::string_view word, int column, const Location& place) {
    if (word.empty()) throw Error(place, formatted("there is no column %d", column));
    double value = 0;
    if (!parse_real(word, value)) throw Error(place, "\"" + std::string(word) + "\" is not a number");
    return value;
}

std::string convert_line(std::string_view line, int column, const std::function<double(double)>& convert,
                         const Location& place) {
    const std::string_view word = find_column(line, column);
    const double value = number_in(word, column, place);
    try {
        std::string converted(line);
        return converted.replace(word.data() - line.data(), word.size(), formatted("%.9g", convert(value)));
    } catch (const Error& error) {
        throw Error(place, error.message(), error.hint(), error.severity());
    }
}

}  // namespace

std::string convert_column(std::string_view text, int column, const std::function<double(double)>& convert,
                           const std::string& name) {
    std::string result;
    Location place{name, 0};
    while (!text.empty()) {
        ++place.line;
        const std::string_view line = take_line(text);
        const std::size_t first = line.find_first_not_of(blanks);
        const bool passes = first == std::string_view::npos || line[first] == '#';
        result += passes ? std::string(line) : convert_line(line, column, convert, place);
        result += '\n';
    }
    return result;
}

}  // namespace infra::ir
