#include "rt/guiding/direction_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace infra {

DirectionMap::DirectionMap(std::span<const double> weights) : choice_(weights), density_(weights.size()) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i)
        density_[i] = static_cast<float>(weights[i] / (sum * cell_size));
}

Vec3 DirectionMap::sample(double u, double v) const {
    const auto cell = static_cast<int>(choice_.draw(u));
    return direction(cell, u, v);
}

Vec3 DirectionMap::direction(int cell, double u, double v) {
    const double height = 2 * ((cell / columns + v) / rows) - 1;
    const double azimuth = 2 * std::numbers::pi * ((cell % columns + u) / columns);
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    return {across * std::cos(azimuth), across * std::sin(azimuth), height};
}

int DirectionMap::cell_of(const Vec3& direction) {
    const int row = std::clamp(static_cast<int>((direction.z + 1) * (0.5 * rows)), 0, rows - 1);
    const double turn = std::atan2(direction.y, direction.x) * (0.5 * std::numbers::inv_pi);
    const int column = std::clamp(static_cast<int>((turn < 0 ? turn + 1 : turn) * columns), 0, columns - 1);
    return row * columns + column;
}

}  // namespace infra
