#include "ir/brdftab/lobe_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "common/format.h"
#include "ir/brdftab/quality.h"
#include "ir/brdftab/radial_scale.h"
#include "ir/brdftab/svg.h"

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

constexpr int panels_in_row = 3;
constexpr double panel_width = 380, panel_height = 236, margin = 14, title_height = 42, legend_height = 40;
constexpr double least_width = 620;  // for the legend
constexpr double radius = 150;
constexpr double same_plane = 0.5 * degree;

constexpr const char* in_plane_color = "#0b5cad";
constexpr const char* across_color = "#c2571a";
constexpr const char* grid_style = "stroke=\"#d4d4d4\" stroke-width=\"0.8\" fill=\"none\"";
constexpr const char* frame_style = "stroke=\"#555\" stroke-width=\"1.1\" fill=\"none\"";
constexpr const char* label_style = "fill=\"#444\"";

/// A plane through the normal: azimuth of its right half, the other half is opposite.
struct Plane {
    double right_phi;
    const char* color;
    const char* dashes;
    const char* name;
};
constexpr Plane planes[] = {{pi, in_plane_color, "", "plane of incidence"},
                            {pi / 2, across_color, " stroke-dasharray=\"6 3.5\"",
                             "across it, \xcf\x86 = \xc2\xb1"
                             "90\xc2\xb0"}};

std::string curve_style(const Plane& plane) {
    return formatted("stroke=\"%s\" stroke-width=\"1.9\" stroke-linejoin=\"round\" fill=\"none\"%s",
                     plane.color, plane.dashes);
}

std::string star_style(const Plane& plane) {
    return formatted("fill=\"%s\" stroke=\"white\" stroke-width=\"0.5\"", plane.color);
}

/// In one panel, angles from the normal, positive to the right.
class Panel {
  public:
    Panel(Svg& svg, Point2 corner, const RadialScale& scale)
        : svg_(svg), origin_{corner.x + panel_width / 2, corner.y + panel_height - 40}, scale_(scale) {}

    Point2 at(double theta, double length) const {
        return {origin_.x + length * std::sin(theta), origin_.y - length * std::cos(theta)};
    }
    Point2 place(double theta, double f) const { return at(theta, radius * scale_.share(f)); }

    void draw_grid(double theta_i) {
        for (const double f : scale_.ticks()) svg_.semicircle(origin_, radius * scale_.share(f), grid_style);
        for (int angle = -60; angle <= 60; angle += 30)
            svg_.line(origin_, at(angle * degree, radius), grid_style);
        svg_.semicircle(origin_, radius, frame_style);
        svg_.line(at(-pi / 2, radius), at(pi / 2, radius), frame_style);
        for (int angle = -90; angle <= 90; angle += 30) {
            const Point2 p = at(angle * degree, radius + 11);
            svg_.text({p.x, p.y + 4}, formatted("%d\xc2\xb0", std::abs(angle)), 11,
                      angle < 0   ? "end"
                      : angle > 0 ? "start"
                                  : "middle",
                      label_style);
        }
        for (const double f : scale_.ticks())
            svg_.text({origin_.x + radius * scale_.share(f), origin_.y + 15}, formatted("%g", f), 10.5,
                      "middle", label_style);
        svg_.text({origin_.x, origin_.y + 15}, formatted("%g", scale_.centre()), 10.5, "middle", label_style);
        svg_.text({origin_.x, origin_.y + 30}, "f / sr\xe2\x81\xbb\xc2\xb9", 11, "middle", label_style);
        svg_.text({origin_.x - radius - 30, origin_.y - radius - 8},
                  formatted("\xce\xb8\xe1\xb5\xa2 = %g\xc2\xb0", std::round(theta_i / degree * 100) / 100),
                  14, "start", "font-weight=\"bold\" fill=\"#222\"");
    }

    /// The arriving ray, from outside the frame inwards.
    void draw_incident(double theta_i) {
        const Point2 tip = at(-theta_i, radius - 14);
        svg_.line(at(-theta_i, radius), at(-theta_i, radius - 22), "stroke=\"#222\" stroke-width=\"1.6\"");
        const Point2 back = at(-theta_i, radius - 4);
        const double x = std::cos(theta_i) * 4, y = -std::sin(theta_i) * 4;
        svg_.polygon({at(-theta_i, radius - 26),
                      {back.x + x - (back.x - tip.x), back.y + y - (back.y - tip.y)},
                      {back.x - x - (back.x - tip.x), back.y - y - (back.y - tip.y)}},
                     "fill=\"#222\"");
    }

    void draw_curve(const BrdfTable& table, double theta_i, const Plane& plane) {
        std::vector<Point2> points;
        for (int half_degrees = -180; half_degrees <= 180; ++half_degrees) {
            const double theta = half_degrees * degree / 2;
            const double phi = theta >= 0 ? plane.right_phi : plane.right_phi + pi;
            points.push_back(place(theta, table_value(table, theta_i, phi, std::abs(theta))));
        }
        svg_.polyline(points, curve_style(plane));
    }

    void draw_stars(const std::vector<BrdfSample>& samples, double theta_i, const Plane& plane) {
        for (const BrdfSample& s : samples) {
            if (std::abs(s.theta_i - theta_i) > same_plane) continue;
            const double from_right = std::abs(std::remainder(s.phi - plane.right_phi, 2 * pi));
            const bool right = from_right < same_plane, left = pi - from_right < same_plane;
            if (right || left) svg_.star(place(right ? s.theta_r : -s.theta_r, s.f), 4.6, star_style(plane));
        }
    }

  private:
    Svg& svg_;
    Point2 origin_;
    const RadialScale& scale_;
};

/// Smallest and largest value that a panel shows.
std::pair<double, double> shown_range(const BrdfTable& table, const std::vector<BrdfSample>& samples,
                                      double theta_i) {
    double low = INFINITY, high = 0;
    const auto add = [&](double f) {
        low = std::min(low, f);
        high = std::max(high, f);
    };
    for (const Plane& plane : planes)
        for (int n = -180; n <= 180; ++n)
            add(table_value(table, theta_i, n < 0 ? plane.right_phi + pi : plane.right_phi,
                            std::abs(n) * degree / 2));
    for (const BrdfSample& s : samples)
        if (std::abs(s.theta_i - theta_i) <= same_plane) add(s.f);
    return {low, high};
}

void draw_legend(Svg& svg, double y, bool with_stars) {
    double x = margin + 20;
    for (const Plane& plane : planes) {
        svg.line({x, y}, {x + 34, y}, curve_style(plane));
        if (with_stars) svg.star({x + 17, y}, 4.6, star_style(plane));
        svg.text({x + 42, y + 4}, plane.name, 12, "start", "fill=\"#222\"");
        x += 190;
    }
    if (with_stars) svg.text({x, y + 4}, "lines: table, stars: measured", 12, "start", "fill=\"#222\"");
}

}  // namespace

std::vector<double> measured_incident_angles(const std::vector<BrdfSample>& samples) {
    constexpr std::size_t most = 6;
    std::set<long> centidegrees;
    for (const BrdfSample& s : samples) centidegrees.insert(std::lround(s.theta_i / degree * 100));
    const std::vector<long> all(centidegrees.begin(), centidegrees.end());
    const std::size_t count = std::min(all.size(), most);
    std::vector<double> angles;
    for (std::size_t n = 0; n < count; ++n)
        angles.push_back(static_cast<double>(all[count < 2 ? 0 : n * (all.size() - 1) / (count - 1)]) / 100 *
                         degree);
    return angles;
}

std::string draw_lobes(const BrdfTable& table, const std::vector<BrdfSample>& samples, const LobePlot& plot) {
    const int count = static_cast<int>(plot.incident_angles.size());
    const int columns = count == 4 ? 2 : std::min(count, panels_in_row);
    const int rows = (count + columns - 1) / columns;
    const double width = std::max(2 * margin + columns * panel_width, least_width);
    const double height = title_height + rows * panel_height + legend_height;
    Svg svg(width, height);
    svg.text({margin + 20, 28}, plot.title, 16, "start", "font-weight=\"bold\" fill=\"#222\"");
    for (int n = 0; n < count; ++n) {
        const double theta_i = plot.incident_angles[static_cast<std::size_t>(n)];
        const auto [low, high] = shown_range(table, samples, theta_i);
        const RadialScale scale(low, high, plot.logarithmic);
        Panel panel(svg, {margin + n % columns * panel_width, title_height + n / columns * panel_height},
                    scale);
        panel.draw_grid(theta_i);
        for (const Plane& plane : planes) panel.draw_curve(table, theta_i, plane);
        for (const Plane& plane : planes) panel.draw_stars(samples, theta_i, plane);
        panel.draw_incident(theta_i);
    }
    draw_legend(svg, height - legend_height / 2, !samples.empty());
    return svg.document();
}

}  // namespace infra::ir
