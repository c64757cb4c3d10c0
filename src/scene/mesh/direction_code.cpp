#include "scene/mesh/direction_code.h"

#include <array>
#include <cmath>

namespace infra {
namespace {

constexpr double steps =
    11584.5;  // 8191.5 * sqrt(2): a component that is not the largest is below 2^13 of them
constexpr std::uint32_t keeps_x = 1 << 3, keeps_z = 1 << 4;
constexpr std::uint32_t component_mask = 0x1fff;
constexpr int first_shift = 5, second_shift = 18;

}  // namespace

std::uint32_t encode_direction(const Vec3& direction) {
    std::uint32_t code = 0;
    std::array<std::uint32_t, 3> size;
    for (int i = 0; i < 3; ++i) {
        size[i] = static_cast<std::uint32_t>(std::abs(direction[i]) * steps + 0.5);
        if (direction[i] < 0) code |= 1u << i;
    }
    if (size[0] + size[1] + size[2] == 0) return no_direction;
    const bool x_first = size[0] <= size[1];
    const std::uint32_t larger = x_first ? size[1] : size[0];
    const bool z_second = size[2] <= larger;
    code |= (x_first ? size[0] : size[1]) << first_shift | (z_second ? size[2] : larger) << second_shift;
    if (x_first) code |= keeps_x;
    if (z_second) code |= keeps_z;
    return code == no_direction ? keeps_x : code;
}

Vec3 decode_direction(std::uint32_t code) {
    if (code == no_direction) return Vec3(0);
    const bool x_first = code & keeps_x, z_second = code & keeps_z;
    const int first = x_first ? 0 : 1;
    const int second = z_second ? 2 : 1 - first;
    const int left_out = 3 - first - second;
    Vec3 direction;
    direction[first] = (code >> first_shift & component_mask) / steps;
    direction[second] = (code >> second_shift & component_mask) / steps;
    const double rest = 1 - direction[first] * direction[first] - direction[second] * direction[second];
    if (rest < 0) return Vec3(0);
    direction[left_out] = std::sqrt(rest);
    for (int i = 0; i < 3; ++i)
        if (code >> i & 1) direction[i] = -direction[i];
    return direction;
}

}  // namespace infra
