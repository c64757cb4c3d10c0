// The walk of a ray through the hierarchy; for the files that trace rays only.
#pragma once

#include <algorithm>
#include <cmath>

#include "rt/geometry/bvh.h"

namespace infra {

/// A bit for each lane whose comparison held.
inline int Bvh::mask_bits(Int4 mask) {
#if defined(__SSE__)
    return __builtin_ia32_movmskps(reinterpret_cast<Float4>(mask));
#else
    return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
#endif
}

template <class Visit, class Limit>
void Bvh::walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const {
    if (nodes_.empty()) return;

    // Single precision serves from the box's neighbourhood on: move there from farther away.
    double enter = 0;
    if (!near_box(origin) && !advance_to_box(origin, direction, limit(), enter)) return;

    const auto component = [](double d) {
        return static_cast<float>(std::fabs(d) < 1e-30 ? std::copysign(1e-30, d) : d);
    };
    const Float4 d{component(direction.x), component(direction.y), component(direction.z), 1.0f};
    const Float4 inverse = 1.0f / d;
    Float4 start[3], slope[3];
    int near_side[3];
    for (int axis = 0; axis < 3; ++axis) {
        const float o = static_cast<float>(origin[axis] + direction[axis] * enter);
        const float i = inverse[axis];
        start[axis] = Float4{o, o, o, o};
        slope[axis] = Float4{i, i, i, i};
        near_side[axis] = i < 0;
    }

    constexpr float outward = 1.0f + 6e-7f;  // rounding of the far distances, four operations
    // Nodes to visit and where the ray enters them, in two arrays so that no load spans two stores.
    std::int32_t stack[stack_size];
    float entry[stack_size];
    int depth = 1;
    stack[0] = 0;
    entry[0] = 0.0f;
    float far = static_cast<float>(limit() - enter) * outward;

    while (depth > 0) {
        const std::int32_t place = stack[--depth];
        if (entry[depth] > far) continue;
        if (place < 0) {
            for (const std::uint32_t* item = &items_[static_cast<std::size_t>(~place)]; *item != end_of_leaf;
                 ++item)
                if (visit(*item)) return;
            far = static_cast<float>(limit() - enter) * outward;
            continue;
        }
        const Node& node = nodes_[static_cast<std::size_t>(place)];
        Float4 t_near = Float4{0, 0, 0, 0};
        Float4 t_far = Float4{far, far, far, far};
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 t0 = (node.plane[near_side[axis]][axis] - start[axis]) * slope[axis];
            const Float4 t1 = (node.plane[1 - near_side[axis]][axis] - start[axis]) * slope[axis] * outward;
            t_near = t0 > t_near ? t0 : t_near;
            t_far = t1 < t_far ? t1 : t_far;
        }
        const int first = depth;
        for (int hits = mask_bits(t_near <= t_far); hits; hits &= hits - 1) {
            const int lane = __builtin_ctz(static_cast<unsigned>(hits));
            const float t = t_near[lane];
            int i = depth++;  // keep the nearest on top
            for (; i > first && entry[i - 1] < t; --i) {
                entry[i] = entry[i - 1];
                stack[i] = stack[i - 1];
            }
            entry[i] = t;
            stack[i] = node.child[lane];
        }
    }
}

}  // namespace infra
