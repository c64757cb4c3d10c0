#include "rt/text/text_line.h"

#include <algorithm>
#include <numeric>

namespace infra {
namespace {

using Glyphs = std::vector<const Glyph*>;  // of a line, nullptr for characters that the font lacks
using Gaps = std::vector<int>;             // from the start of each to that of the next; first, of the line

Gaps uniform_gaps(const Glyphs& glyphs) {
    Gaps gaps{0};
    for (const Glyph* glyph : glyphs) gaps.push_back(glyph ? character_size : 0);
    return gaps;
}

// Half the distance on either side of a character; blanks are of mean width.
Gaps squeezed_gaps(const Glyphs& glyphs, int mean_width, int distance) {
    const int half = distance / 2;
    Gaps gaps;
    int room_before = 0;
    bool begun = false;
    for (const Glyph* glyph : glyphs) {
        if (glyph && !begun) room_before = half;
        begun = begun || glyph;
        const bool drawn = glyph && !glyph->is_blank();
        gaps.push_back(drawn ? room_before + half - glyph->left() : room_before);
        room_before = drawn ? glyph->right() + half : glyph ? mean_width : 0;
    }
    gaps.push_back((begun ? room_before : half) + half);
    return gaps;
}

// Gives each run of characters, up to a wide blank, the width of as many columns.
void spread_to_columns(const Glyphs& glyphs, int column, Gaps& gaps) {
    constexpr std::size_t wide = 3;
    const std::size_t count = glyphs.size();
    for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
        std::size_t columns = 0;
        for (bool ends = false; end < count && !ends;) {
            const std::size_t first = end++;
            if (!glyphs[first]) continue;
            while (end < count && glyphs[end] && glyphs[end]->is_blank()) ++end;
            columns += end - first;
            ends = end - first > wide;
        }
        const auto from = gaps.begin() + static_cast<std::ptrdiff_t>(begin) + 1;
        const auto to = gaps.begin() + static_cast<std::ptrdiff_t>(end) + 1;
        int missing = static_cast<int>(columns) * column - std::accumulate(from, to, 0);
        for (auto gap = from; gap != to; ++gap) {
            const int share = missing / static_cast<int>(to - gap);
            *gap += share;
            missing -= share;
        }
    }
}

Gaps gaps_between(const Glyphs& glyphs, int mean_width, int distance) {
    if (distance == 0) return uniform_gaps(glyphs);
    Gaps gaps = squeezed_gaps(glyphs, mean_width, std::abs(distance));
    if (distance > 0) spread_to_columns(glyphs, mean_width + distance, gaps);
    return gaps;
}

}  // namespace

TextLine::TextLine(std::string_view text, const Font& font, int distance) {
    Glyphs glyphs;
    for (const char c : text) glyphs.push_back(font.glyph(c));
    const Gaps gaps = gaps_between(glyphs, font.mean_width(), distance);
    int place = 0, reached = 0;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        place += gaps[i];
        reached = std::max(reached, place);
        if (glyphs[i] && !glyphs[i]->is_blank()) letters_.push_back({place, reached, glyphs[i]});
    }
    width_ = place + gaps.back();
}

// As RADIANCE, up to the first character that starts behind the place. `reached` rises from letter to letter.
bool TextLine::covers(double x, double y) const {
    const int column = static_cast<int>(x);
    const auto begins_later = [](int place, const Letter& letter) { return place < letter.reached; };
    auto letter = std::upper_bound(letters_.begin(), letters_.end(), column - character_size, begins_later);
    for (; letter != letters_.end() && letter->reached <= column; ++letter)
        if (column - letter->start < character_size && letter->glyph->covers(x - letter->start, y))
            return true;
    return false;
}

}  // namespace infra
