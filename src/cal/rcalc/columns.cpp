#include "columns.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

#include "binary.h"

namespace infra::rcalc {
namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

double column_function(const double* a, const cal::Host& host) {
    const double number = a[0] + .5;
    constexpr double largest = 1e6;
    if (!(number < largest)) return 0;
    const int column = static_cast<int>(number);
    return host.channel_value(column == 0 ? column_count_channel : column);
}

constexpr cal::Builtin builtins[] = {{"in", 1, false, column_function}};

}  // namespace

std::span<const cal::Builtin> column_builtins() { return builtins; }

bool Columns::read(std::FILE* file) {
    if (settings_.input_form == NumberForm::text) return read_line(file);
    bytes_.resize(settings_.binary_columns * number_size(settings_.input_form));
    return std::fread(bytes_.data(), 1, bytes_.size(), file) == bytes_.size();
}

bool Columns::read_line(std::FILE* file) {
    line_.clear();
    for (int c; (c = std::getc(file)) != EOF;) {
        line_ += static_cast<char>(c);
        if (c == '\n') break;
    }
    return !line_.empty();
}

bool Columns::separated_by_blanks() const { return !settings_.exact_blanks && is_space(settings_.separator); }

const char* Columns::find(int number) const {
    const char* at = line_.c_str();
    for (int i = 1; i < number && *at; ++i) {
        if (separated_by_blanks()) {
            while (is_space(*at)) ++at;
            while (*at && !is_space(*at)) ++at;
        } else {
            while (*at && *at++ != settings_.separator) {
            }
        }
    }
    return at;
}

double Columns::value(int number) {
    if (settings_.input_form == NumberForm::text) return std::strtod(find(number), nullptr);
    if (static_cast<std::size_t>(number) > settings_.binary_columns) return 0;
    const std::size_t size = number_size(settings_.input_form);
    return decode_number(bytes_.data() + (static_cast<std::size_t>(number) - 1) * size, settings_.input_form);
}

std::size_t Columns::count() const {
    if (settings_.binary_columns > 0) return settings_.binary_columns;
    if (!separated_by_blanks()) {
        const auto separators = std::count(line_.begin(), line_.end(), settings_.separator);
        const bool empty = line_.empty() || line_.front() == '\n';
        return empty ? 0 : static_cast<std::size_t>(separators) + 1;
    }
    std::size_t words = 0;
    for (std::size_t i = 0; i < line_.size(); ++i)
        if (!is_space(line_[i]) && (i == 0 || is_space(line_[i - 1]))) ++words;
    return words;
}

}  // namespace infra::rcalc
