#include "common/views/lens.h"

#include <cmath>
#include <numbers>

#include "common/disk_square.h"

namespace infra {
bool move_on_lens(const View& view, double diameter, const std::array<double, 3>& chance, Vec3& origin,
                  Vec3& direction) {
    const bool flat = view.type == ViewType::perspective || view.type == ViewType::parallel;
    const double ahead = view.type == ViewType::perspective ? dot(direction, view.direction) : 1.0;
    // A parallel view's rays start all over the picture, so that the lens moves along with them.
    const Vec3 middle = origin - direction * (view.fore / ahead);
    const Vec3 in_focus = middle + direction * (view.distance / ahead);
    const auto [x, y] = disk_of_square({chance[0], chance[1]});
    Vec3 point = middle + normalize(view.image_x) * (0.5 * diameter * x) +
                 normalize(view.image_y) * (0.5 * diameter * y);
    if (!flat) point += view.direction * (std::numbers::pi / 4 * diameter * (0.5 - chance[2]));
    const Vec3 to_focus = in_focus - point;
    const double distance = length(to_focus);
    if (!(distance > 0) || !std::isfinite(distance)) return false;
    direction = to_focus / distance;
    const double fore =
        view.type == ViewType::perspective ? view.fore / dot(direction, view.direction) : view.fore;
    origin = point + direction * fore;
    return true;
}

}  // namespace infra
