#include "common/parse_number.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

namespace infra {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Drops one leading '+', which from_chars doesn't know, unless another sign follows it.
std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

/// Numbers without an exponent and of few digits, most of a scene: the quotient of two integers that a double
/// holds exactly is the nearest double.
/// source: W. D. Clinger, "How to Read Floating Point Numbers Accurately", PLDI 1990.
///   returns  false for all others, wrong ones too
bool parse_short_real(std::string_view text, double& value) {
    constexpr std::size_t most_digits = 15;
    static constexpr double power_of_ten[most_digits + 1] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                             1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = !text.empty() && text[0] == '-';
    text.remove_prefix(negative);
    if (text.size() > most_digits) return false;
    std::int64_t digits = 0;
    std::size_t point = text.size();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_digit(text[i])) {
            digits = 10 * digits + (text[i] - '0');
        } else if (text[i] == '.' && point == text.size()) {
            point = i;
        } else {
            return false;
        }
    }
    const bool has_point = point < text.size();
    if (text.size() == has_point) return false;
    const double size = double(digits) / power_of_ten[has_point ? text.size() - point - 1 : 0];
    value = negative ? -size : size;
    return true;
}

template <class Integer>
bool parse_integer(std::string_view text, Integer& value) {
    if (text.size() == 1 && is_digit(text[0])) {
        value = text[0] - '0';
        return true;
    }
    text = without_plus(text);
    Integer parsed{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (problem != std::errc() || end != text.data() + text.size()) return false;
    value = parsed;
    return true;
}

}  // namespace

bool parse_real(std::string_view text, double& value) {
    if (parse_short_real(text, value)) return true;
    text = without_plus(text);
    const std::size_t first = !text.empty() && text[0] == '-';
    if (first >= text.size() || !(is_digit(text[first]) || text[first] == '.'))
        return false;  // inf, nan, "--"
    double parsed = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (problem == std::errc::invalid_argument || end != text.data() + text.size()) return false;
    if (problem == std::errc::result_out_of_range) {  // both ways: only strtod tells which
        parsed = std::strtod(std::string(text).c_str(), nullptr);
        if (!std::isfinite(parsed)) return false;
    }
    value = parsed;
    return true;
}

bool parse_int(std::string_view text, int& value) { return parse_integer(text, value); }
bool parse_int(std::string_view text, long long& value) { return parse_integer(text, value); }

}  // namespace infra
