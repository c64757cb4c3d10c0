// Where the characters of a line of text stand.
#pragma once

#include <string_view>
#include <vector>

#include "rt/text/font.h"

namespace infra {

/// Distances are in units of 1 / character_size of a character's square.
class TextLine {
  public:
    /// distance: between neighbours; 0 sets all characters into squares side by side, below 0 its size is the
    /// gap between any two and at both ends, above 0 gaps are adjusted so that characters stand in columns on
    /// average and start anew behind more than two blanks, as tables want it. Characters that the font lacks
    /// take no room. font: must outlive this.
    TextLine(std::string_view text, const Font& font, int distance);

    int width() const { return width_; }

    /// Whether the place is inside a character: x from the start of the line, 0 <= x < width(), and y from
    /// its bottom, 0 <= y <= character_size.
    bool covers(double x, double y) const;

  private:
    struct Letter {
        int start;
        int reached;  ///< the largest start up to this one: a letter is drawn from there on
        const Glyph* glyph;
    };
    std::vector<Letter> letters_;
    int width_ = 0;
};

}  // namespace infra
