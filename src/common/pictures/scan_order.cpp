#include "common/pictures/scan_order.h"

#include <algorithm>

#include "common/format.h"
#include "common/parse_number.h"

namespace infra {
namespace {

constexpr int most_pixels_a_side = 1 << 20;

bool names_axis(const std::string& word, char letter) {
    return word.size() == 2 && (word[0] == '-' || word[0] == '+') && word[1] == letter;
}

bool names_axes(const std::vector<std::string>& words, char first, char second) {
    return words.size() == 4 && names_axis(words[0], first) && names_axis(words[2], second);
}

}  // namespace

bool is_resolution_line(std::string_view text) {
    const auto words = split_words(text);
    return names_axes(words, 'Y', 'X') || names_axes(words, 'X', 'Y');
}

std::optional<ScanOrder> parse_scan_order(std::string_view text) {
    const auto words = split_words(text);
    const bool y_first = names_axes(words, 'Y', 'X');
    if (!y_first && !names_axes(words, 'X', 'Y')) return std::nullopt;
    const int y = y_first ? 0 : 2, x = 2 - y;
    ScanOrder order;
    order.y_major = y_first;
    order.y_decreases = words[y][0] == '-';
    order.x_decreases = words[x][0] == '-';
    if (!parse_int(words[y + 1], order.height) || !parse_int(words[x + 1], order.width)) return std::nullopt;
    if (std::min(order.width, order.height) < 1 || std::max(order.width, order.height) > most_pixels_a_side)
        return std::nullopt;
    return order;
}

}  // namespace infra
