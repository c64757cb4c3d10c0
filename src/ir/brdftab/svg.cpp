#include "ir/brdftab/svg.h"

#include <cmath>
#include <numbers>

#include "common/format.h"

namespace infra::ir {
namespace {

/// Short, so that a file can be read: a hundredth of a pixel.
std::string pair_of(Point2 p) { return formatted("%.2f,%.2f", p.x, p.y); }

std::string list_of(const std::vector<Point2>& points) {
    std::string list;
    for (const Point2& p : points) list += (list.empty() ? "" : " ") + pair_of(p);
    return list;
}

std::string escaped(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (c == '&')
            text += "&amp;";
        else if (c == '<')
            text += "&lt;";
        else
            text += c;
    }
    return text;
}

}  // namespace

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::line(Point2 a, Point2 b, std::string_view style) { polyline({a, b}, style); }

void Svg::polyline(const std::vector<Point2>& points, std::string_view style) {
    body_ += "<polyline points=\"" + list_of(points) + "\" " + std::string(style) + "/>\n";
}

void Svg::polygon(const std::vector<Point2>& points, std::string_view style) {
    body_ += "<polygon points=\"" + list_of(points) + "\" " + std::string(style) + "/>\n";
}

void Svg::semicircle(Point2 centre, double radius, std::string_view style) {
    body_ += "<path d=\"M" + pair_of({centre.x - radius, centre.y}) +
             formatted(" A%.2f,%.2f 0 0 1 ", radius, radius) + pair_of({centre.x + radius, centre.y}) +
             "\" " + std::string(style) + "/>\n";
}

void Svg::star(Point2 centre, double radius, std::string_view style) {
    constexpr double inner = 0.45;
    std::vector<Point2> points;
    for (int n = 0; n < 10; ++n) {
        const double angle = std::numbers::pi * n / 5, r = n % 2 == 0 ? radius : inner * radius;
        points.push_back({centre.x + r * std::sin(angle), centre.y - r * std::cos(angle)});
    }
    polygon(points, style);
}

void Svg::text(Point2 at, std::string_view words, double size, std::string_view anchor,
               std::string_view style) {
    body_ += formatted("<text x=\"%.2f\" y=\"%.2f\" font-size=\"%g\" text-anchor=\"", at.x, at.y, size) +
             std::string(anchor) + "\" " + std::string(style) + ">" + escaped(words) + "</text>\n";
}

std::string Svg::document() const {
    return formatted(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
               "font-family=\"Helvetica, Arial, sans-serif\">\n"
               "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
               width_, height_, width_, height_) +
           body_ + "</svg>\n";
}

}  // namespace infra::ir
