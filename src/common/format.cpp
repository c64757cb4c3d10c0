#include "common/format.h"

#include <cstdarg>
#include <cstdio>

#include "common/text.h"

namespace infra {

std::string formatted(const char* format, ...) {
    std::va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    va_end(arguments);
    std::string text(length > 0 ? length : 0, '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    return text;
}

std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size();) {
        while (i < text.size() && is_blank(text[i])) ++i;
        const std::size_t start = i;
        while (i < text.size() && !is_blank(text[i])) ++i;
        if (i > start) words.emplace_back(text.substr(start, i - start));
    }
    return words;
}

std::string join_command(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        if (!line.empty()) line += ' ';
        bool quote = word.empty();
        for (const char c : word) quote |= is_blank(c) || c == '"' || c == '\'';
        const char mark = word.find('"') == std::string::npos ? '"' : '\'';
        if (quote) line += mark;
        for (const char c : word) line += c == '\n' || c == '\r' ? ' ' : c;  // a header line stays one line
        if (quote) line += mark;
    }
    return line;
}

}  // namespace infra
