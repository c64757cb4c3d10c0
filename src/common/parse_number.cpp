#include "common/parse_number.h"

#include <charconv>
#include <cmath>
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

template <class Integer>
bool parse_integer(std::string_view text, Integer& value) {
    text = without_plus(text);
    Integer parsed{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (problem != std::errc() || end != text.data() + text.size()) return false;
    value = parsed;
    return true;
}

}  // namespace

bool parse_real(std::string_view text, double& value) {
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
