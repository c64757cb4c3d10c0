#include "bsdf/data_numbers.h"

#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"

namespace infra {
namespace {

bool is_separator(char c) { return is_blank(c) || c == ','; }
bool ends_number(char c) { return is_separator(c) || c == '{' || c == '}'; }

}  // namespace

void DataNumbers::skip_blanks() {
    while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
}

bool DataNumbers::take(char brace) {
    if (!sees(brace)) return false;
    ++at_;
    skip_blanks();
    return true;
}

double DataNumbers::next() {
    if (at_end()) throw error("the scattering data end too early");
    const auto end = std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), ends_number);
    const std::string_view word = text_.substr(at_, static_cast<std::size_t>(end - text_.begin()) - at_);
    double value = 0;
    if (!parse_real(word, value) || std::fabs(value) > 1e30)
        throw error("\"" + std::string(word.empty() ? text_.substr(at_, 1) : word) +
                    "\" among the scattering data is not a number");
    at_ += word.size();
    skip_blanks();
    return value;
}

float DataNumbers::next_value() {
    const std::size_t at = at_;
    const double value = next();
    if (value >= 0) return static_cast<float>(value);
    if (negative_count_++ == 0) first_negative_ = at;
    return 0;
}

void DataNumbers::warn_of_negatives(std::vector<std::string>& warnings) const {
    if (negative_count_ == 0) return;
    const char* many = negative_count_ > 1 ? ", the first of them here" : "";
    warnings.push_back(
        Error(place(first_negative_),
              formatted("%zu of the scattering data below 0%s: taken for 0", negative_count_, many))
            .what());
}

Location DataNumbers::place(std::size_t at) const {
    Location where = start_;
    where.line +=
        static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    return where;
}

Error DataNumbers::error(std::string_view message, std::string_view hint) const {
    return Error(place(at_), message, hint);
}

}  // namespace infra
