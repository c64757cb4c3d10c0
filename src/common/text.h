// Blanks and lines of texts, which every reader of a format meets.
#pragma once

#include <algorithm>
#include <string_view>

namespace infra {

/// White space: blank, tab and what ends lines and pages.
constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The first line of `text`, which loses it and its '\n'. A '\r' before that stays.
constexpr std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

}  // namespace infra
