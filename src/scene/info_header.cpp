#include "scene/info_header.h"

#include <cctype>

#include "common/text.h"
#include "scene/octree_format.h"

namespace infra {
namespace {

constexpr std::size_t longest_header = 1 << 20;

std::string_view without_indent(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text;
}

}  // namespace

std::string InfoHeader::format() const {
    std::string format;
    for (const std::string& line : lines) {
        if (!is_format_line(line)) continue;
        format = without_indent(std::string_view(line).substr(format_key.size()));
        while (!format.empty() && is_blank(format.back())) format.pop_back();
    }
    return format;
}

std::optional<InfoHeader> read_info_header(std::FILE* file) {
    InfoHeader header;
    std::string line;
    std::size_t length = 0;
    for (int c = std::getc(file); c != EOF; c = std::getc(file)) {
        if (++length > longest_header || (length == 1 && !std::isprint(c))) return std::nullopt;
        if (c != '\n') {
            line += static_cast<char>(c);
            continue;
        }
        if (line.empty() || line == "\r") return header;
        header.lines.push_back(line);
        line.clear();
    }
    return std::nullopt;
}

bool is_format_line(std::string_view line) { return line.starts_with(format_key); }

bool sets_the_same(std::string_view line, std::string_view setting) {
    if (line.empty() || setting.empty() || is_blank(line[0]) != is_blank(setting[0])) return false;
    line = without_indent(line);
    setting = without_indent(setting);
    std::size_t end = 0;
    while (end < setting.size() && setting[end] != '=' && !is_blank(setting[end])) ++end;
    if (end == 0 || end >= line.size() || line.substr(0, end) != setting.substr(0, end)) return false;
    const bool by_blank = end < setting.size() && is_blank(setting[end]);
    return by_blank ? is_blank(line[end]) : line[end] == '=';
}

std::optional<std::string> read_dimensions(std::FILE* file) {
    constexpr std::size_t longest = 256;
    const int first = std::getc(file);
    std::string text;
    if (first == '+' || first == '-') {
        for (int c = first; c != EOF && c != '\n' && text.size() < longest; c = std::getc(file))
            text += static_cast<char>(c);
        return text;
    }
    if (first != octree_magic >> 8) return std::nullopt;
    std::getc(file);
    for (int strings = 0; text.size() < longest;) {
        const int c = std::getc(file);
        if (c == EOF || (c == 0 && ++strings == 4)) break;
        text += c == 0 ? ' ' : static_cast<char>(c);
    }
    return text;
}

}  // namespace infra
