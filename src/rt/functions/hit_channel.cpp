#include "rt/functions/hit_channel.h"

#include <algorithm>
#include <string>

#include "cal/ray_library.h"
#include "common/error.h"

namespace infra {

double hit_channel(const Interaction& at, const Transform& to_local, double side, int number) {
    const auto& m = to_local.matrix;
    const double scale = to_local.magnification();
    const auto direction = [&](const Vec3& v, int i) {
        const double scaled = v.x * m[0][i] + v.y * m[1][i] + v.z * m[2][i];
        return scale == 1 ? scaled : scaled / scale;
    };
    if (number < 1) throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
    if (number < cal::surface_normal) return direction(at.ray->direction, number - cal::ray_direction);
    if (number < cal::intersection_point) return side * direction(at.normal, number - cal::surface_normal);
    if (number < cal::total_distance) {
        const int i = number - cal::intersection_point;
        return at.point.x * m[0][i] + at.point.y * m[1][i] + at.point.z * m[2][i] + m[3][i];
    }
    if (number == cal::total_distance) return (at.ray->path_before + at.distance) * scale;
    if (number == cal::ray_dot) return side * std::clamp(at.cosine, -1.0, 1.0);
    if (number == cal::world_scale) return scale;
    if (number < cal::world_i) return m[3][number - cal::world_origin];
    if (number < cal::world_j) return m[0][number - cal::world_i] / scale;
    if (number < cal::world_k) return m[1][number - cal::world_j] / scale;
    if (number < cal::shadow_distance) return m[2][number - cal::world_k] / scale;
    if (number == cal::shadow_distance) return (at.distance + at.ray->shadow_before) * scale;
    if (number == cal::local_u || number == cal::local_v) return at.local_uv[number - cal::local_u];
    if (number >= cal::perturbed_normal && number < cal::light_direction)
        throw Error("NxP, RdotP and CrP are used where there are none",
                    "*func and *data materials have them: plasfunc, BRTDfunc and their kin");
    if (number >= cal::light_direction && number < cal::light_direction + 3)
        throw Error("DxA, DyA and DzA are used where there are none", "prism1 and prism2 have them");
    throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
}

}  // namespace infra
