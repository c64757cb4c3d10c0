#include "rt/programs/view_numbers.h"

#include <algorithm>
#include <cmath>

namespace infra {

ViewNumbers numbers_of(const View& v) {
    return {double(static_cast<char>(v.type)),
            v.point.x,
            v.point.y,
            v.point.z,
            v.direction.x,
            v.direction.y,
            v.direction.z,
            v.up.x,
            v.up.y,
            v.up.z,
            v.distance,
            v.horizontal,
            v.vertical,
            v.shift,
            v.lift,
            v.fore,
            v.aft,
            v.image_x.x,
            v.image_x.y,
            v.image_x.z,
            v.image_y.x,
            v.image_y.y,
            v.image_y.z,
            v.image_width,
            v.image_height};
}

std::optional<View> view_of(const ViewNumbers& n) {
    constexpr double last_letter = 127;
    if (!std::ranges::all_of(n, [](double number) { return std::isfinite(number); })) return std::nullopt;
    if (n[0] < 0 || n[0] > last_letter) return std::nullopt;
    const auto type = view_type_of(static_cast<char>(n[0]));
    if (!type) return std::nullopt;
    View v;
    v.type = *type;
    v.point = {n[1], n[2], n[3]};
    v.direction = {n[4], n[5], n[6]};
    v.up = {n[7], n[8], n[9]};
    v.distance = n[10], v.horizontal = n[11], v.vertical = n[12];
    v.shift = n[13], v.lift = n[14], v.fore = n[15], v.aft = n[16];
    v.image_x = {n[17], n[18], n[19]};
    v.image_y = {n[20], n[21], n[22]};
    v.image_width = n[23], v.image_height = n[24];
    const auto points_somewhere = [](const Vec3& d) { return length(d) > 0 && std::isfinite(length(d)); };
    if (!(v.image_width > 0) || !(v.image_height > 0) || !points_somewhere(v.direction) ||
        !points_somewhere(v.image_x) || !points_somewhere(v.image_y))
        return std::nullopt;
    return v;
}

}  // namespace infra
