// Setting up views and casting their rays.
// source: the behaviour of RADIANCE 6.1's view options, checked against its vwrays for every type
// (tests/common/view_test.cpp).
#include "common/views/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "common/error.h"

namespace infra {
namespace {

using std::numbers::pi;

constexpr double tiny = 1e-6;
constexpr double degree = pi / 180;

/// Scales v to unit length and returns the length it had; 0 leaves it alone.
double make_unit(Vec3& v) {
    const double size = length(v);
    if (size > 0) v /= size;
    return size;
}

[[noreturn]] void fail(const char* what, const char* hint = "") { throw Error(what, hint); }

/// Extent at distance 1 of a view of `size` (degrees, or scene units), or a negative value where the size is
/// illegal.
double image_extent(ViewType type, double size, bool is_horizontal) {
    constexpr double illegal = -1;
    const double half = size / 2 * degree;
    if (!(size > tiny)) return illegal;
    switch (type) {
        case ViewType::parallel:
            return size;
        case ViewType::perspective:
            return size < 180 - tiny ? 2 * std::tan(half) : illegal;
        case ViewType::cylindrical:
            if (is_horizontal) return size <= 360 + tiny ? 2 * half : illegal;
            return size < 180 - tiny ? 2 * std::tan(half) : illegal;
        case ViewType::angular:
            return size <= 360 + tiny ? 2 * half : illegal;
        case ViewType::hemispherical:
            return size <= 180 + tiny ? 2 * std::sin(half) : illegal;
        case ViewType::planisphere:
            return size < 360 - tiny ? 2 * std::tan(half / 2) : illegal;
    }
    return illegal;
}

/// The inverse of image_extent for a part of the image; NaN where there is no such view.
double size_of_extent(ViewType type, double extent, bool is_horizontal) {
    switch (type) {
        case ViewType::parallel:
            return extent;
        case ViewType::perspective:
            return 2 * std::atan(extent / 2) / degree;
        case ViewType::cylindrical:
            return is_horizontal ? extent / degree : 2 * std::atan(extent / 2) / degree;
        case ViewType::angular:
            return extent / degree;
        case ViewType::hemispherical:
            return 2 * std::asin(extent / 2) / degree;
        case ViewType::planisphere:
            return 4 * std::atan(extent / 2) / degree;
    }
    return extent;
}

/// Direction through image plane coordinates (u, v), in the frame (right, up, ahead), not normalised; u and v
/// are in units of the extents. Returns false outside a fisheye's circle.
bool frame_direction(const View& view, double u, double v, Vec3& d) {
    u *= view.image_width;
    v *= view.image_height;
    const double r2 = u * u + v * v;
    switch (view.type) {
        case ViewType::parallel:
            d = {0, 0, 1};
            return true;
        case ViewType::perspective:
            d = {u, v, 1};
            return true;
        case ViewType::cylindrical:
            d = {std::sin(u), v, std::cos(u)};
            return true;
        case ViewType::hemispherical:  // orthographic: the radius is the sine
            if (r2 > 1) return false;
            d = {u, v, std::sqrt(1 - r2)};
            return true;
        case ViewType::angular: {  // equidistant: the radius is the angle
            const double angle = std::sqrt(r2);
            if (angle > pi) return false;
            const double scale = angle > tiny ? std::sin(angle) / angle : 1;
            d = {u * scale, v * scale, std::cos(angle)};
            return true;
        }
        case ViewType::planisphere: {  // stereographic: the radius is the tangent of half the angle
            const double scale = 2 / (1 + r2);
            d = {u * scale, v * scale, (1 - r2) / (1 + r2)};
            return true;
        }
    }
    return false;
}

}  // namespace

const char* view_type_name(ViewType type) {
    switch (type) {
        case ViewType::perspective:
            return "perspective";
        case ViewType::parallel:
            return "parallel";
        case ViewType::cylindrical:
            return "cylindrical";
        case ViewType::hemispherical:
            return "hemispherical";
        case ViewType::angular:
            return "angular";
        case ViewType::planisphere:
            return "planisphere";
    }
    return "unknown";
}

std::optional<ViewType> view_type_of(char letter) {
    if (std::string_view("vlchas").find(letter) == std::string_view::npos) return std::nullopt;
    return static_cast<ViewType>(letter);
}

void set_up_view(View& view) {
    if (view.fore < -tiny || view.aft < -tiny || (view.aft > tiny && view.aft <= view.fore))
        fail("illegal fore/aft clipping plane",
             "-vo must not be negative, -va must be 0 or greater than -vo");
    if (!(view.distance > tiny)) fail("illegal view distance");
    view.distance *= make_unit(view.direction);
    if (view.distance == 0) fail("zero view direction", "see -vd");
    if (make_unit(view.up) == 0) fail("zero view up vector", "see -vu");

    Vec3 right = cross(view.direction, view.up);
    if (make_unit(right) == 0) fail("view up parallel to view direction", "see -vu and -vd");
    const Vec3 top = cross(right, view.direction);

    view.image_width = image_extent(view.type, view.horizontal, true);
    view.image_height = image_extent(view.type, view.vertical, false);
    if (view.image_width < 0) fail("illegal horizontal view size", "see -vh");
    if (view.image_height < 0) fail("illegal vertical view size", "see -vv");
    view.image_x = right * view.image_width;
    view.image_y = top * view.image_height;
}

bool view_ray(const View& view, double x, double y, Vec3& origin, Vec3& direction, double& max_distance) {
    const double u = x - 0.5 + view.shift;
    const double v = y - 0.5 + view.lift;
    Vec3 local;
    if (!frame_direction(view, u, v, local)) return false;

    const Vec3 ahead = view.direction;
    Vec3 scaled = ahead * local.z;
    if (view.type != ViewType::parallel)
        scaled += view.image_x * (local.x / view.image_width) + view.image_y * (local.y / view.image_height);
    origin = view.point + scaled * view.fore;
    if (view.type == ViewType::parallel) origin += view.image_x * u + view.image_y * v;

    // Clipping is measured along the view direction (perspective, parallel), from the axis (panorama) or from
    // the eye (fisheyes): in each case along `scaled`, whose length turns it into distance along the ray.
    const double stretch = length(scaled);
    direction = scaled / stretch;
    max_distance =
        view.aft > tiny ? (view.aft - view.fore) * stretch : std::numeric_limits<double>::infinity();
    return true;
}

std::optional<ViewLocation> view_locate(const View& view, const Vec3& point) {
    const Vec3 offset = point - view.point;
    const double ahead = dot(offset, view.direction);
    // Coordinates to the right and up in scene units.
    const double right = dot(offset, view.image_x) / view.image_width;
    const double top = dot(offset, view.image_y) / view.image_height;
    const double range = length(offset);
    double u = 0, v = 0, clip = 0;  // image plane coordinates; what the clipping planes cut
    double stretch = 1;             // distance along the ray per unit of clip
    switch (view.type) {
        case ViewType::parallel:
            u = right, v = top, clip = ahead;
            break;
        case ViewType::perspective:
            if (std::abs(ahead) <= tiny) return std::nullopt;
            u = right / std::abs(ahead), v = top / std::abs(ahead), clip = ahead;
            stretch = range / std::abs(ahead);
            break;
        case ViewType::cylindrical: {
            const double radius = std::hypot(right, ahead);
            if (radius <= tiny) return std::nullopt;
            u = std::atan2(right, ahead), v = top / radius, clip = radius;
            stretch = range / radius;
            break;
        }
        case ViewType::hemispherical:
            if (range == 0) return std::nullopt;
            u = right / range, v = top / range, clip = ahead < 0 ? -range : range;
            break;
        case ViewType::angular: {
            if (range == 0) return std::nullopt;
            const double sine = std::hypot(right, top);
            const double angle = std::atan2(sine, ahead);
            u = sine > 0 ? angle * right / sine : angle;
            v = sine > 0 ? angle * top / sine : 0;
            clip = range;
            break;
        }
        case ViewType::planisphere:
            if (range + ahead <= tiny * range) return std::nullopt;
            u = right / (range + ahead), v = top / (range + ahead), clip = range;
            break;
    }
    ViewLocation location;
    location.x = u / view.image_width + 0.5 - view.shift;
    location.y = v / view.image_height + 0.5 - view.lift;
    location.distance = (clip - view.fore) * stretch;
    location.behind = clip <= view.fore;
    location.beyond = view.aft > tiny && clip >= view.aft;
    location.outside = !(location.x > 0 && location.x < 1 && location.y > 0 && location.y < 1);
    return location;
}

double view_aspect(const View& view) { return view.image_height / view.image_width; }

void fit_resolution(double aspect, double& pixel_aspect, int& x_resolution, int& y_resolution) {
    if (pixel_aspect <= tiny) {
        pixel_aspect = aspect * x_resolution / y_resolution;
    } else if (aspect * x_resolution > pixel_aspect * y_resolution) {
        x_resolution = std::max(1, int(y_resolution / aspect * pixel_aspect + 0.5));
    } else {
        y_resolution = std::max(1, int(x_resolution * aspect / pixel_aspect + 0.5));
    }
}

void crop_view(View& view, double x0, double y0, double x1, double y1) {
    if (x0 > x1) std::swap(x0, x1);
    if (y0 > y1) std::swap(y0, y1);
    const double width = x1 - x0, height = y1 - y0;
    if (!(width > tiny && height > tiny)) fail("zero crop area");
    set_up_view(view);
    view.horizontal = size_of_extent(view.type, view.image_width * width, true);
    view.vertical = size_of_extent(view.type, view.image_height * height, false);
    if (std::isnan(view.horizontal) || std::isnan(view.vertical)) fail("illegal crop for hemispherical view");
    view.shift = ((x0 + x1) / 2 - 0.5 + view.shift) / width;
    view.lift = ((y0 + y1) / 2 - 0.5 + view.lift) / height;
    set_up_view(view);
}

}  // namespace infra
