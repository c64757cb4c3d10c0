#include "rt/ambient/aimed_rays.h"

#include "rt/ambient/cosine_direction.h"

namespace infra {
namespace {

[[gnu::always_inline]] inline void aim_each(AimedRays& rays, int count, const Vec3& u, const Vec3& v,
                                            const Vec3& axis) {
    for (int i = 0; i < count; ++i) {
        const Vec3 local = cosine_direction(rays.across[0][i], rays.across[1][i]);
        for (int k = 0; k < 3; ++k)
            rays.direction[k][i] = u[k] * local.x + v[k] * local.y + axis[k] * local.z;
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
