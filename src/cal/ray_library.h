// The function library of the ray tracer and the channels by which rays reach it.
#pragma once

#include "cal/library.h"

namespace infra::cal {

/// Numbers of the channels that the ray tracer's Host answers. lib/rayinit.cal gives them their names; those
/// up to local_v are RADIANCE's. Vectors take three successive numbers.
enum RayChannel {
    ray_direction = 1,       ///< Dx Dy Dz
    surface_normal = 4,      ///< Nx Ny Nz
    intersection_point = 7,  ///< Px Py Pz
    total_distance = 10,     ///< T
    ray_dot = 11,            ///< Rdot, within [-1, 1]
    world_scale = 12,        ///< S
    world_origin = 13,       ///< Tx Ty Tz
    world_i = 16,            ///< Ix Iy Iz
    world_j = 19,            ///< Jx Jy Jz
    world_k = 22,            ///< Kx Ky Kz
    shadow_distance = 25,    ///< Ts
    local_u = 26,            ///< Lu
    local_v = 27,            ///< Lv
    perturbed_normal = 28,   ///< NxP NyP NzP, for the *func and *data materials
    perturbed_dot = 31,      ///< RdotP
    material_color = 32,     ///< CrP CgP CbP
    light_direction = 35,    ///< DxA DyA DzA, for prism1 and prism2
};

/// A Library with the ray tracer's functions and lib/rayinit.cal loaded. throws Error if that file is not
/// found.
Library make_ray_library();

}  // namespace infra::cal
