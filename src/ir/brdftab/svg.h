// A small writer of SVG drawings. Lengths in pixels, x to the right, y down.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace infra::ir {

struct Point2 {
    double x, y;
};

class Svg {
  public:
    Svg(double width, double height);

    /// `style` is a list of SVG attributes, as in `stroke="#333" fill="none"`.
    void line(Point2 a, Point2 b, std::string_view style);
    void polyline(const std::vector<Point2>& points, std::string_view style);
    void polygon(const std::vector<Point2>& points, std::string_view style);
    /// The upper half of a circle.
    void semicircle(Point2 centre, double radius, std::string_view style);
    /// A five-pointed star.
    void star(Point2 centre, double radius, std::string_view style);
    /// `anchor`: start, middle or end, where `at` is in the text's length.
    void text(Point2 at, std::string_view words, double size, std::string_view anchor,
              std::string_view style = {});

    /// The complete document.
    std::string document() const;

  private:
    double width_, height_;
    std::string body_;
};

}  // namespace infra::ir
