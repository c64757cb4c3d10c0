#include "bsdf/tristimulus.h"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "common/spectra/color_primaries.h"

namespace infra {
namespace {

const glm::dmat3& sharp_sensors() {
    static const glm::dmat3 matrix = glm::transpose(
        glm::dmat3(1.2694, -0.0988, -0.1706, -0.8364, 1.8006, 0.0357, 0.0297, -0.0315, 1.0018));
    return matrix;
}

}  // namespace

Xyz xyz_of_yuv(double luminance, double u, double v) {
    if (!(v > 0)) return Xyz(luminance);
    return {luminance * 9 * u / (4 * v), luminance, luminance * (12 - 3 * u - 20 * v) / (4 * v)};
}

glm::dvec3 sharp_of_xyz(const Xyz& color) { return sharp_sensors() * color; }

Xyz xyz_of_sharp(const glm::dvec3& sharp) {
    static const glm::dmat3 inverse = glm::inverse(sharp_sensors());
    return inverse * sharp;
}

std::array<double, 3> rgb_of_xyz(const Xyz& color) {
    static const glm::dmat3 matrix = xyz_to_rgb(radiance_primaries());
    const double luminance = color.y;
    if (!(luminance > 0)) return {0, 0, 0};
    const glm::dvec3 rgb = matrix * color;
    const double lowest = std::min({rgb.x, rgb.y, rgb.z});
    const double kept = lowest < 0 ? luminance / (luminance - lowest) : 1.0;
    std::array<double, 3> result;
    for (int i = 0; i < 3; ++i)
        result[static_cast<std::size_t>(i)] = std::max(0.0, luminance + kept * (rgb[i] - luminance));
    return result;
}

}  // namespace infra
