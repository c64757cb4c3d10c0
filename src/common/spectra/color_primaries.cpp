#include "common/spectra/color_primaries.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace infra {
namespace {

constexpr double tolerance = 1e-4;  // of chromaticities that count as the same, RADIANCE's

bool same(const Chromaticity& a, const Chromaticity& b) {
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

bool within_limits(const Chromaticity& c) {
    const auto within = [](double value) { return value > -2 && value < 3; };
    return within(c.x) && within(c.y) && within(c.x + c.y);
}

bool is_white(const Chromaticity& c) {
    const auto within = [](double value) { return value > tolerance && value < 1 - tolerance; };
    return within(c.x) && within(c.y);
}

/// X, Y, Z of a chromaticity, of sum 1.
glm::dvec3 xyz(const Chromaticity& c) { return {c.x, c.y, 1 - c.x - c.y}; }

/// XYZ seen under the equal-energy white to the same under another.
/// source: von Kries' adaptation with the "sharp" sensors of Finlayson, Drew and Funt (1994)
glm::dmat3 adaptation_to(const Chromaticity& white) {
    const glm::dmat3 sensors = glm::transpose(
        glm::dmat3(1.2694, -0.0988, -0.1706, -0.8364, 1.8006, 0.0357, 0.0297, -0.0315, 1.0018));
    const glm::dvec3 from = sensors * glm::dvec3(1, 1, 1);
    const glm::dvec3 to = sensors * (xyz(white) / white.y);
    glm::dmat3 gains(0.0);
    for (int i = 0; i < 3; ++i) gains[i][i] = to[i] / from[i];
    return glm::inverse(sensors) * gains * sensors;
}

}  // namespace

bool usable(const Primaries& primaries) {
    const Chromaticity corners[] = {primaries.red, primaries.green, primaries.blue, primaries.white};
    if (!is_white(primaries.white)) return false;
    for (int i = 0; i < 3; ++i) {
        if (!within_limits(corners[i])) return false;
        for (int j = i + 1; j < 4; ++j)
            if (same(corners[i], corners[j])) return false;
    }
    const glm::dmat3 corners_xyz(xyz(primaries.red), xyz(primaries.green), xyz(primaries.blue));
    return std::abs(glm::determinant(corners_xyz)) > tolerance;
}

glm::dmat3 rgb_to_xyz(const Primaries& primaries) {
    const glm::dmat3 corners(xyz(primaries.red), xyz(primaries.green), xyz(primaries.blue));
    const glm::dvec3 amounts = glm::inverse(corners) * (xyz(primaries.white) / primaries.white.y);
    return {corners[0] * amounts.x, corners[1] * amounts.y, corners[2] * amounts.z};
}

glm::dmat3 xyz_to_rgb(const Primaries& primaries) { return glm::inverse(rgb_to_xyz(primaries)); }

glm::dmat3 adapted_xyz_to_rgb(const Primaries& primaries) {
    return xyz_to_rgb(primaries) * adaptation_to(primaries.white);
}

}  // namespace infra
