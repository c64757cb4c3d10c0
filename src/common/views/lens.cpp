#include "common/views/lens.h"

#include <cmath>
#include <numbers>

namespace infra {
namespace {

/// Point of the unit disk, areas kept. source: Shirley & Chiu, "A Low Distortion Map Between Disk and
/// Square", JGT 2 (1997).
std::array<double, 2> disk_point(double x, double y) {
    const double a = 2 * x - 1, b = 2 * y - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::fabs(a) > std::fabs(b);
    const double radius = wide ? a : b;
    const double angle = (std::numbers::pi / 4) * (wide ? b / a : 2 - a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

bool move_on_lens(const View& view, double diameter, const std::array<double, 3>& chance, Vec3& origin,
                  Vec3& direction) {
    const bool flat = view.type == ViewType::perspective || view.type == ViewType::parallel;
    const double ahead = view.type == ViewType::perspective ? dot(direction, view.direction) : 1.0;
    // A parallel view's rays start all over the picture, so that the lens moves along with them.
    const Vec3 middle = origin - direction * (view.fore / ahead);
    const Vec3 in_focus = middle + direction * (view.distance / ahead);
    const auto [x, y] = disk_point(chance[0], chance[1]);
    Vec3 point = middle + normalize(view.image_x) * (0.5 * diameter * x) +
                 normalize(view.image_y) * (0.5 * diameter * y);
    if (!flat) point += view.direction * (std::numbers::pi / 4 * diameter * (0.5 - chance[2]));
    const Vec3 to_focus = in_focus - point;
    const double distance = length(to_focus);
    if (!(distance > 0)) return false;
    direction = to_focus / distance;
    const double fore =
        view.type == ViewType::perspective ? view.fore / dot(direction, view.direction) : view.fore;
    origin = point + direction * fore;
    return true;
}

}  // namespace infra
