#include "rt/text/font.h"

#include <algorithm>

#include "common/format.h"
#include "common/number_text.h"

namespace infra {
namespace {

long long integer_within(NumberText& text, const std::string& what, long long least, long long most) {
    const long long value = text.integer(what);
    if (value < least || value > most)
        throw text.error(formatted("%lld is not %s", value, what.c_str()),
                         formatted("%lld to %lld", least, most));
    return value;
}

std::vector<Glyph::Corner> read_corners(NumberText& text, int code) {
    constexpr long long most_corners = 32000;
    const long long count =
        integer_within(text, formatted("the number of corners of character %d", code), 0, most_corners);
    const std::string what = formatted("a corner of character %d", code);
    std::vector<Glyph::Corner> corners;
    for (long long n = 0; n < count; ++n) {
        const long long x = integer_within(text, what, 0, character_size);
        const long long y = integer_within(text, what, 0, character_size);
        corners.push_back({static_cast<int>(x), static_cast<int>(y)});
    }
    return corners;
}

}  // namespace

Glyph::Glyph(std::vector<Corner> corners) : corners_(std::move(corners)) {
    constexpr int middle = 128;
    left_ = right_ = bottom_ = top_ = middle;
    for (const Corner& c : corners_) {
        left_ = std::min(left_, c.x);
        right_ = std::max(right_, c.x);
        bottom_ = std::min(bottom_, c.y);
        top_ = std::max(top_, c.y);
    }
}

// Counts the edges that a line to the right crosses. Which edges it meets is decided for the middle of the
// cell of integers that the place lies in, so that it never runs through a corner.
bool Glyph::covers(double x, double y) const {
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    if (column < left_ || column >= right_ || row < bottom_ || row >= top_) return false;
    bool inside = false;
    const Corner* a = &corners_.back();
    for (const Corner& b : corners_) {
        const bool rises = b.y > row;
        if ((a->y > row) != rises) {
            const bool a_right = a->x > column, b_right = b.x > column;
            const bool crosses =
                a_right == b_right ? a_right : rises != ((a->y - y) * (b.x - x) > (a->x - x) * (b.y - y));
            inside ^= crosses;
        }
        a = &b;
    }
    return inside;
}

Font::Font(std::string_view content, const std::string& name) {
    NumberText text(content, name);
    int drawn = 0, total_width = 0;
    while (!text.at_end()) {
        const int code = static_cast<int>(integer_within(text, "the code of a character", 1, 255));
        auto& slot = glyphs_[code];
        if (slot) throw text.error(formatted("character %d stands twice", code));
        slot = std::make_unique<const Glyph>(read_corners(text, code));
        if (slot->width() > 0 && slot->height() > 0) {
            ++drawn;
            total_width += slot->width();
        }
    }
    if (drawn > 0) mean_width_ = total_width / drawn;
}

}  // namespace infra
