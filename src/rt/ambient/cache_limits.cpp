#include "rt/ambient/cache_limits.h"

#include <algorithm>
#include <cmath>

namespace infra {

CacheLimits CacheLimits::of_scene(double cube_size, double accuracy, int resolution) {
    constexpr double shortest = 1e-5, widest_range = 64, widest_share = 0.2;
    CacheLimits limits;
    limits.accuracy = accuracy;
    limits.least_radius = resolution > 0 ? cube_size / resolution : 0.0;
    limits.most_radius = widest_share * cube_size;
    if (resolution > 0) limits.most_radius = std::min(limits.most_radius, widest_range * limits.least_radius);
    limits.least_radius = std::max(limits.least_radius, shortest);
    if (limits.most_radius <= limits.least_radius) limits.most_radius = widest_range * limits.least_radius;
    limits.farthest = 10 * cube_size + 1000;
    return limits;
}

double CacheLimits::radius_for(double bend) const {
    constexpr double flat = 1e-12;
    return bend > flat ? std::sqrt(std::sqrt(4 / bend)) : most_radius;
}

void CacheLimits::confine(IrradianceValue& value) const {
    double &shorter = value.radius[0], &longer = value.radius[1];
    shorter = std::max(std::min(shorter, longer), least_radius);
    longer = std::max(longer, least_radius);
    const double scale = 1 / std::sqrt(value.weight);
    shorter *= scale;
    longer = std::min(longer * scale, 2 * shorter);
    shorter = std::min(shorter, most_radius);
    longer = std::min(longer, most_radius);
}

}  // namespace infra
