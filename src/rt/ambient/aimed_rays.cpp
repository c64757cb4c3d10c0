#include "rt/ambient/aimed_rays.h"

#include <cmath>
#include <numbers>

#include "rt/ambient/cosine_direction.h"

namespace infra {
namespace {

/// cosine_direction() without a branch, in the scene's coordinates.
[[gnu::always_inline]] inline void aim_each(AimedRays& rays, int count, const Vec3& u, const Vec3& v,
                                            const Vec3& axis) {
    for (int i = 0; i < count; ++i) {
        const double a = 2 * rays.across[0][i] - 1, b = 2 * rays.across[1][i] - 1;
        const bool wide = std::fabs(a) > std::fabs(b);
        const double radius = wide ? a : b, other = wide ? b : a;
        double s, c;
        small_sin_cos((std::numbers::pi / 4) * (other / (radius != 0 ? radius : 1.0)), s, c);
        const double x = radius * (wide ? c : s), y = radius * (wide ? s : c);
        const double below = 1 - radius * radius;
        const double z = std::sqrt(below > 0 ? below : 0.0);
        for (int axis_of_scene = 0; axis_of_scene < 3; ++axis_of_scene)
            rays.direction[axis_of_scene][i] =
                u[axis_of_scene] * x + v[axis_of_scene] * y + axis[axis_of_scene] * z;
    }
}

using Aim = void (*)(AimedRays&, int, const Vec3&, const Vec3&, const Vec3&);

void aim_portably(AimedRays& rays, int count, const Vec3& u, const Vec3& v, const Vec3& axis) {
    aim_each(rays, count, u, v, axis);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void aim_by_fours(AimedRays& rays, int count, const Vec3& u, const Vec3& v,
                                          const Vec3& axis) {
    aim_each(rays, count, u, v, axis);
}
const Aim best_aim = __builtin_cpu_supports("avx2") ? aim_by_fours : aim_portably;
#else
const Aim best_aim = aim_portably;
#endif

}  // namespace

void AimedRays::aim(int count, const Vec3& u, const Vec3& v, const Vec3& axis) {
    best_aim(*this, count, u, v, axis);
}

}  // namespace infra
