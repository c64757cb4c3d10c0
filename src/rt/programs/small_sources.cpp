#include "rt/programs/small_sources.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "rt/sources/light_source.h"

namespace infra {
namespace {

using std::numbers::pi;

constexpr int circle_corners = 16;
/// A regular polygon around a circle of radius 1 that has its area.
const double corner_radius = std::sqrt(2 * pi / (circle_corners * std::sin(2 * pi / circle_corners)));

/// Keeps the side of a line x = at (axis 0) or y = at (axis 1) that `sign` points to.
ImagePolygon cut(const ImagePolygon& polygon, std::size_t axis, double at, double sign) {
    ImagePolygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ImagePoint& a = polygon[i];
        const ImagePoint& b = polygon[(i + 1) % polygon.size()];
        const double inside_a = sign * (a[axis] - at), inside_b = sign * (b[axis] - at);
        if (inside_a >= 0) result.push_back(a);
        if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0)) {
            const double t = inside_a / (inside_a - inside_b);
            result.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
        }
    }
    return result;
}

double cross_product(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

ImagePoint centroid(const ImagePolygon& polygon) {
    ImagePoint sum{0, 0};
    double area = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const double part = cross_product(polygon[0], polygon[i], polygon[i + 1]);
        area += part;
        for (int k = 0; k < 2; ++k) sum[k] += part * (polygon[0][k] + polygon[i][k] + polygon[i + 1][k]) / 3;
    }
    if (area == 0) return polygon[0];
    return {sum[0] / area, sum[1] / area};
}

/// Corners around an ellipse.
std::vector<Vec3> around(const Vec3& center, const Vec3& u, const Vec3& v) {
    std::vector<Vec3> corners;
    for (int i = 0; i < circle_corners; ++i) {
        const double angle = 2 * pi * i / circle_corners;
        corners.push_back(center + corner_radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return corners;
}

/// Points of the scene along the outline of a source as the view has it; none where it has none.
std::vector<Vec3> outline_of(const LightSource& source, const View& view, bool& is_exact) {
    const bool parallel = view.type == ViewType::parallel;
    is_exact = true;
    Vec3 u, v;
    if (source.distant()) {
        if (parallel || view.aft > 0) return {};
        make_frame(source.center, u, v);
        const double cosine = source.least_cosine, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const double far = 1 + 2 * view.fore;
        std::vector<Vec3> corners = around(cosine * source.center, sine * u, sine * v);
        for (Vec3& corner : corners) corner = view.point + far * normalize(corner);
        return corners;
    }
    const Vec3 to_source = source.center - view.point;
    const double distance = length(to_source);
    if (!(distance > source.radius)) return {};
    const Vec3 ahead = parallel ? view.direction : to_source / distance;
    switch (source.extent) {
        case LightSource::Extent::sphere: {
            // Where straight lines from the eye touch it.
            const double sine = parallel ? 0 : source.radius / distance;
            make_frame(ahead, u, v);
            const double radius = source.radius * std::sqrt(1 - sine * sine);
            return around(source.center - ahead * (source.radius * sine), radius * u, radius * v);
        }
        case LightSource::Extent::cylinder: {
            const double radius = source.size / (4 * source.radius);  // both were set from its length
            const Vec3 axis = source.half_axis[0], across = cross(axis, ahead);
            if (!(length(across) > 0)) return {};
            const Vec3 side = normalize(across) * radius;
            return {source.center - axis - side, source.center + axis - side, source.center + axis + side,
                    source.center - axis + side};
        }
        default: {
            if (dot(ahead, source.normal) >= 0) return {};  // its back
            Vec3 a = source.half_axis[0], b = source.half_axis[1];
            const double area = 4 * length(cross(a, b));
            if (!(area > 0)) return {};
            if (source.round) {
                return around(source.center, normalize(a) * source.radius, normalize(b) * source.radius);
            }
            const double scale = std::sqrt(source.size / area);
            constexpr double alike = 1e-6;
            is_exact = std::abs(scale - 1) < alike &&
                       std::abs(length(a + b) - source.radius) < alike * source.radius + alike;
            a *= scale, b *= scale;
            return {source.center - a - b, source.center + a - b, source.center + a + b,
                    source.center - a + b};
        }
    }
}

/// The ray to a place of the picture. False where there is none.
bool find_ray(const View& view, const Frame& frame, const ImagePoint& place, Vec3& origin, Vec3& direction,
              double& reach) {
    return view_ray(view, place[0] / frame.picture.width, place[1] / frame.picture.height, origin, direction,
                    reach);
}

/// Paints one source into one pixel, of which it covers a part.
void paint_pixel(const SmallSource& small, const ImagePolygon& part, std::size_t index, int column, int row,
                 const View& view, Tracer& tracer, Frame& frame) {
    const LightSource& source = tracer.scene().source(small.source);
    Vec3 origin, direction;
    double reach = 0;
    const ImagePoint place = centroid(small.is_exact ? part : small.outline);
    if (!find_ray(view, frame, place, origin, direction, reach)) return;
    if (source.is_spot && source.beam.misses(direction)) return;
    tracer.start_stream(index);
    Ray ray = tracer.primary(origin, direction, std::isfinite(reach) ? reach : 0);
    ray.fore = view.fore;
    Interaction at(ray);
    tracer.trace(at);
    if (at.surface != source.surface) return;
    const auto share = static_cast<float>(std::min(1.0, polygon_area(part)));
    const std::span<float> pixel = frame.picture.at(column, row);
    for (int c = 0; c < at.channels(); ++c) pixel[c] += share * (at.radiance[c] - pixel[c]);
    if (frame.depth.empty()) return;
    float& depth = frame.depth[static_cast<std::size_t>(row) * frame.picture.width + column];
    depth = std::min(depth, static_cast<float>(at.apparent_distance()));
}

}  // namespace

double polygon_area(const ImagePolygon& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += cross_product(polygon[0], polygon[i], polygon[i + 1]);
    return std::abs(sum) / 2;
}

ImagePolygon clipped(const ImagePolygon& polygon, double x0, double y0, double x1, double y1) {
    ImagePolygon result = cut(polygon, 0, x0, 1);
    result = cut(result, 0, x1, -1);
    result = cut(result, 1, y0, 1);
    result = cut(result, 1, y1, -1);
    if (result.size() < 3) result.clear();
    return result;
}

double polygon_width(const ImagePolygon& polygon) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ImagePoint& a = polygon[i];
        const ImagePoint& b = polygon[(i + 1) % polygon.size()];
        const double side = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (side == 0) continue;
        double height = 0;
        for (const ImagePoint& c : polygon)
            height = std::max(height, std::abs(cross_product(a, b, c)) / side);
        least = std::min(least, height);
    }
    return least;
}

std::vector<SmallSource> find_small_sources(const CompiledScene& scene, const View& view, int width,
                                            int height, int spacing) {
    std::vector<SmallSource> result;
    for (int i = 0; i < static_cast<int>(scene.sources().size()); ++i) {
        const LightSource& source = scene.source(i);
        if (source.is_virtual() || source.passes_unseen || (source.is_weak && !source.is_glow)) continue;
        SmallSource small{.source = i, .outline = {}, .is_exact = true};
        const std::vector<Vec3> corners = outline_of(source, view, small.is_exact);
        for (const Vec3& corner : corners) {
            const std::optional<ViewLocation> location = view_locate(view, corner);
            if (!location || location->behind || location->beyond) break;
            small.outline.push_back({location->x * width, location->y * height});
        }
        if (corners.empty() || small.outline.size() < corners.size()) continue;
        if (polygon_width(small.outline) > (small.is_exact ? spacing : 1)) continue;
        const double longest = 0.5 * std::max(width, height);  // around the back of a panorama
        if (polygon_area(small.outline) > longest * spacing) continue;
        if (clipped(small.outline, 0, 0, width, height).empty()) continue;
        result.push_back(std::move(small));
    }
    return result;
}

void paint_small_sources(const std::vector<SmallSource>& sources, const View& view, Tracer& tracer,
                         int first_row, Frame& frame) {
    const int width = frame.picture.width, height = frame.picture.height;
    std::size_t stream = static_cast<std::size_t>(width) * height;  // after those of the pixels
    for (const SmallSource& small : sources) {
        const ImagePolygon seen = clipped(small.outline, 0, 0, width, height - first_row);
        if (seen.empty()) continue;
        ImagePoint low = seen[0], high = seen[0];
        for (const ImagePoint& point : seen)
            for (int k = 0; k < 2; ++k) {
                low[k] = std::min(low[k], point[k]);
                high[k] = std::max(high[k], point[k]);
            }
        for (int y = int(low[1]); y < std::min(height, int(std::ceil(high[1]))); ++y)
            for (int x = int(low[0]); x < std::min(width, int(std::ceil(high[0]))); ++x) {
                const ImagePolygon part = clipped(seen, x, y, x + 1, y + 1);
                if (!part.empty()) paint_pixel(small, part, stream++, x, height - 1 - y, view, tracer, frame);
            }
    }
}

}  // namespace infra
