// Unit vectors in 4 bytes, as .rtm files keep normals: within 0.006 degrees.
#pragma once

#include <cstdint>

#include "common/vec.h"

namespace infra {

/// No vector: the code of a vertex without a normal.
inline constexpr std::uint32_t no_direction = 0;

/// Code of a unit vector, never no_direction.
///   format  RADIANCE's direction code: bits 0..2 the signs of x, y, z (set: negative), bit 3 set if |x| is
///   kept
///           and not |y|, bit 4 set if |z| is kept and not the larger of |x|, |y|; then the two kept
///           components in units of sqrt(1/2) / 8191.5, 13 bits each
std::uint32_t encode_direction(const Vec3& direction);

/// Unit vector of a code; (0, 0, 0) for no_direction, and for codes that no vector has.
Vec3 decode_direction(std::uint32_t code);

}  // namespace infra
