// The walk of a ray through the hierarchy; for the files that trace rays only.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "rt/geometry/bvh.h"

namespace infra {

/// A ray as the kernel takes it: near the hierarchy's box, in single precision.
struct BvhRay {
    static constexpr int stack_size = 512;
    typedef float Four __attribute__((vector_size(16)));

    const BvhNode* nodes;
    const std::uint8_t* leaves;   ///< 32 bytes a slot
    const std::uint8_t* records;  ///< of triangles by slot, record_size bytes each
    std::uint32_t record_size;
    std::uint32_t triangle_count;  ///< slots behind these hold other shapes
    Four origin;                   ///< the fourth is 0
    Four inverse;                  ///< of the direction; the fourth is 0
    std::int32_t near_side[3];     ///< by axis, which side of a box the ray meets first
    std::int32_t axis[4];          ///< across, across, along the ray; the last again
    float shear[2];                ///< what takes a coordinate along the ray off those across
    float inverse_along;
    float error;  ///< of a projected coordinate (bvh_kernel.h)
    float limit;  ///< distance beyond which nothing is asked for
    /// Called with a leaf's first slot and a bit for each that may be met; may lower `limit`. True ends the
    /// walk.
    bool (*visit)(BvhRay& ray, std::uint32_t slot, unsigned hits);
};

template <class Visit, class Limit>
void Bvh::walk(const Vec3& origin, const Vec3& direction, Visit&& visit, Limit&& limit) const {
    if (nodes_.empty()) return;

    // Single precision serves from the box's neighbourhood on: move there from farther away.
    double enter = 0;
    if (!near_box(origin) && !advance_to_box(origin, direction, limit(), enter)) return;

    struct Query : BvhRay {
        Visit& visit_item;
        Limit& current_limit;
        double moved;
        const std::uint32_t* others;

        void update() {
            constexpr float outward = 1.0f + 6e-7f;
            BvhRay::limit = static_cast<float>(current_limit() - moved) * outward;
        }
        static bool visit_leaf(BvhRay& ray, std::uint32_t slot, unsigned hits) {
            auto& query = static_cast<Query&>(ray);
            for (; hits; hits &= hits - 1) {
                const std::uint32_t at = slot + static_cast<std::uint32_t>(std::countr_zero(hits));
                const std::uint32_t item =
                    at < ray.triangle_count ? at : query.others[at - ray.triangle_count];
                if (query.visit_item(item)) return true;
            }
            query.update();
            return false;
        }
    };
    Query query{{}, visit, limit, enter, others_.data()};
    query.nodes = nodes_.data();
    query.leaves = reinterpret_cast<const std::uint8_t*>(leaves_.data());
    query.records = records_;
    query.record_size = record_size_;
    query.triangle_count = triangle_count_;
    query.visit = Query::visit_leaf;
    query.error = 1.2e-6f * reach_;
    // Within the box's neighbourhood a slope of 1e-12 is as good as none. Sizes compare like their bits.
    constexpr std::int32_t least = std::bit_cast<std::int32_t>(1e-12f), sign = std::int32_t{1} << 31;
    typedef std::int32_t Bits __attribute__((vector_size(16)));
    const BvhRay::Four given{static_cast<float>(direction.x), static_cast<float>(direction.y),
                             static_cast<float>(direction.z), 1.0f};
    const Bits size_of_given = std::bit_cast<Bits>(given) & ~sign;
    const Bits size = size_of_given > least ? size_of_given : Bits{least, least, least, least};
    const BvhRay::Four slope = std::bit_cast<BvhRay::Four>(size | (std::bit_cast<Bits>(given) & sign));
    query.inverse = 1.0f / slope;
    query.inverse[3] = 0.0f;
    query.origin = BvhRay::Four{static_cast<float>(origin.x + direction.x * enter),
                                static_cast<float>(origin.y + direction.y * enter),
                                static_cast<float>(origin.z + direction.z * enter), 0.0f};
    for (int axis = 0; axis < 3; ++axis) query.near_side[axis] = slope[axis] < 0;
    if (triangle_count_ > 0) {
        const int y_wins = size[1] > size[0];
        const int along = size[2] > std::max(size[0], size[1]) ? 2 : y_wins;
        static constexpr int next[] = {1, 2, 0, 1};
        const int x = next[along], y = next[along + 1];
        query.axis[0] = x;
        query.axis[1] = y;
        query.axis[2] = query.axis[3] = along;
        query.inverse_along = query.inverse[along];
        query.shear[0] = -slope[x] * query.inverse_along;
        query.shear[1] = -slope[y] * query.inverse_along;
    }
    query.update();
    kernel_(query);
}

}  // namespace infra
