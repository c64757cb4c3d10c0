#include "rt/materials/bsdf_hit.h"

#include <algorithm>
#include <cmath>

namespace infra {

bool BsdfHit::orient(const Vec3& normal, const Vec3& up, const Vec3& to_viewer) {
    const Vec3 right = cross(up, normal);
    const double size = length(right);
    if (!(size > 0 && std::isfinite(size))) return false;
    x = right / size;
    y = cross(normal, x);
    z = normal;
    viewer = to_local(to_viewer);
    return true;
}

Vec3 BsdfHit::jittered_viewer(double projected_solid_angle) const {
    const double width = std::sqrt(projected_solid_angle) * std::clamp(sharpness, 0.0, 1.0);
    if (!(width > 0)) return viewer;
    const double dx = 0.5 - random.uniform(), dy = 0.5 - random.uniform();
    return normalize(viewer + Vec3{width * dx, width * dy, 0});
}

Spectrum BsdfHit::spectrum_of(const Xyz& color) const {
    if (color.x == color.y && color.y == color.z)
        return Spectrum(channels.count(), static_cast<float>(color.y));
    const auto [r, g, b] = rgb_of_xyz(color);
    return channels.from_rgb(r, g, b);
}

Spectrum BsdfHit::spectrum_of(const ScatterTable& table, const ScatterEntry& entry, const Vec3& in,
                              const Vec3& out) const {
    return spectrum_of(table.colored() ? table.color(in, out) : Xyz(entry.value));
}

}  // namespace infra
