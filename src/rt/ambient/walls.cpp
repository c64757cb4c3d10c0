#include "rt/ambient/walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace infra {
namespace {

constexpr int fewest_divisions = 8;
constexpr double sectors_per_radian = wall_sectors / (2 * std::numbers::pi);

}  // namespace

std::uint32_t near_walls(std::span<const MeshCorner> corners, int n, const Vec3& axis,
                         const CacheLimits& limits, const IrradianceValue& value) {
    if (n < fewest_divisions) return 0;
    const auto corner = [&](int i, int j) -> const MeshCorner& {
        return corners[static_cast<std::size_t>(i * n + j)];
    };
    const double reach[2] = {value.radius[0] * limits.accuracy, value.radius[1] * limits.accuracy};
    const double too_near = 1 / (limits.least_radius * limits.accuracy + 0.001);

    double overhead = 0;
    int count = 0;
    for (int i = n / 4; i < n * 3 / 4; ++i)
        for (int j = n / 4; j < n * 3 / 4; ++j, ++count) overhead += corner(i, j).nearness;
    overhead /= count;
    if (overhead * reach[0] >= 1 || overhead >= too_near) return 0;

    std::uint32_t sectors = 0;
    const double half_width =
        0.5 * std::numbers::pi / n * sectors_per_radian;  // of a cell at the rim, in sectors
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; j += i == 0 || i == n - 1 ? 1 : n - 1) {
            const MeshCorner& end = corner(i, j);
            if (end.nearness <= 1e-6 || end.nearness >= too_near) continue;
            const double size = length(end.place);
            const double x = (end.place.x * axis.x + end.place.y * axis.y) / size;
            const double y = (end.place.y * axis.x - end.place.x * axis.y) / size;
            // Where the ray's end, at 1 / nearness, lies within the ellipse
            const double edge2 =
                (x * x * reach[0] * reach[0] + y * y * reach[1] * reach[1]) / (x * x + y * y);
            if (edge2 * end.nearness * end.nearness <= x * x + y * y) continue;
            const double middle = std::atan2(y, x) * sectors_per_radian;
            const int from = static_cast<int>(std::floor(middle - half_width));
            const int to = static_cast<int>(std::floor(middle + half_width));
            for (int s = from; s <= to; ++s) sectors |= 1u << (s & (wall_sectors - 1));
        }
    return sectors;
}

}  // namespace infra
