#include "ir/genirsky/placed_numbers.h"

#include <algorithm>

#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra::ir {
namespace {

constexpr std::string_view separators = " \t\r,";

NumberLine parse_line(std::string_view line, const std::string& name, int number) {
    NumberLine numbers;
    std::size_t start = line.find_first_not_of(separators);
    while (start != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, start), line.size());
        const std::string_view word = line.substr(start, end - start);
        PlacedNumber found{0, number, static_cast<int>(start) + 1};
        if (!parse_real(word, found.value))
            throw Error(Location{name, number, found.column},
                        "expected a finite number, found \"" + std::string(word) + "\"");
        numbers.push_back(found);
        start = line.find_first_not_of(separators, end);
    }
    return numbers;
}

}  // namespace

std::vector<PlacedNumber> NumberText::all() const {
    std::vector<PlacedNumber> numbers;
    for (const NumberLine& line : lines) numbers.insert(numbers.end(), line.begin(), line.end());
    return numbers;
}

NumberText parse_numbers(std::string_view text, const std::string& name) {
    NumberText result{name, {}, 1};
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = take_line(text);
        result.last_line = number;
        NumberLine numbers = parse_line(line.substr(0, line.find('#')), name, number);
        if (!numbers.empty()) result.lines.push_back(std::move(numbers));
    }
    if (result.lines.empty()) throw Error(result.end(), "the file has no numbers");
    return result;
}

NumberText read_numbers(const std::string& path) {
    return parse_numbers(read_text_file(path), shown_name(path));
}

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace infra::ir
