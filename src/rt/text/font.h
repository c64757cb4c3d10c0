// Fonts of characters with straight edges.
//
// A font file is a list of integers: a character's code, 1 to 255, the number of its corners, and the x and y
// of each, 0 to 255 from left to right and from bottom to top. '#' starts a comment. The corners of all
// outlines of a character, holes among them, make one closed chain: a place is inside if the chain runs
// around it an odd number of times. A character without corners is a blank. source: RADIANCE's File Formats,
// "Font".
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace infra {

/// Side of the square that characters are drawn in.
inline constexpr int character_size = 255;

class Glyph {
  public:
    struct Corner {
        int x, y;
    };
    explicit Glyph(std::vector<Corner> corners);

    bool is_blank() const { return corners_.empty(); }
    int left() const { return left_; }
    int right() const { return right_; }
    int width() const { return right_ - left_; }
    int height() const { return top_ - bottom_; }

    /// Whether a place in 0 .. character_size, both ways, is inside.
    bool covers(double x, double y) const;

  private:
    std::vector<Corner> corners_;
    int left_, right_, bottom_, top_;  ///< of the box around the corners and the middle of the square
};

class Font {
  public:
    /// text: of a font file called `name`.
    ///   throws  Error that names the line
    Font(std::string_view text, const std::string& name);

    /// nullptr for a character that the font lacks.
    const Glyph* glyph(char character) const { return glyphs_[static_cast<unsigned char>(character)].get(); }
    /// Mean width of the characters that are not blank, rounded down; 0 if there is none.
    int mean_width() const { return mean_width_; }

  private:
    std::unique_ptr<const Glyph> glyphs_[256];
    int mean_width_ = 0;
};

}  // namespace infra
