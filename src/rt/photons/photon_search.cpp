// source: Arya & Mount, "Algorithms for Fast Vector Quantization" (1993), for the distance to a cell that is
// kept up to date, axis by axis, on the way down.
#include "rt/photons/photon_search.h"

#include <cmath>

namespace infra {
namespace {

/// Cosine of the normals, times 127, up to which a photon lies on another surface. RADIANCE draws it anew
/// for each photon, evenly up to twice this.
constexpr float least_facing = 0.01f * 127;

constexpr std::size_t deepest = 32;

/// Asks for the coordinates of a leaf's photons ahead of their use.
void fetch(const PhotonMap::Leaf& leaf) {
    constexpr std::uint32_t floats_of_line = 16;
    for (std::uint32_t i = 0; i < 3 * leaf.count; i += floats_of_line) __builtin_prefetch(leaf.x + i);
}

}  // namespace

/// A part of the tree that is left for later.
struct PhotonSearch::Pending {
    std::uint32_t node;
    float distance2;             ///< from the query to its cell
    std::array<float, 3> axis2;  ///< the parts of that along the axes
};

bool PhotonQuery::accepts(const PhotonMap::Attributes& photon) const {
    if (only_caustic && !photon.is_caustic()) return false;
    if (any_direction) return true;
    float facing = 0;
    for (std::size_t i = 0; i < 3; ++i)
        facing += normal_[i] * static_cast<float>(photon.direction(static_cast<int>(i)));
    return facing > least_facing;
}

void PhotonSearch::find(const PhotonMap& map, const PhotonQuery& query, std::size_t most, float limit2) {
    if (found_.size() < most) found_.resize(most);
    most_ = most;
    count_ = 0;
    radius2_ = limit2;

    std::array<Pending, deepest> pending;
    std::size_t depth = 0;
    const std::uint32_t inner_count = map.inner_count();
    Pending here{1, 0, {0, 0, 0}};
    for (;;) {
        while (here.node <= inner_count) {
            const float* const photon = map.inner(here.node);
            const auto axis = static_cast<std::size_t>(PhotonMap::Attributes(photon[3], photon[4]).axis());
            const float offset = query.position[axis] - photon[axis];
            const std::uint32_t near = 2 * here.node + (offset >= 0 ? 1 : 0);
            Pending& far = pending[depth];
            far = here;
            far.node = near ^ 1;
            far.axis2[axis] = offset * offset;
            far.distance2 = far.axis2[0] + far.axis2[1] + far.axis2[2];
            if (far.distance2 < radius2_) ++depth;
            if (near > inner_count) {  // both are leaves: their photons come while others are looked at
                fetch(map.leaf(near));
                if (far.distance2 < radius2_) fetch(map.leaf(far.node));
            } else if (2 * near <= inner_count) {
                __builtin_prefetch(map.inner(2 * near));
            }
            float distance2 = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const float d = query.position[i] - photon[i];
                distance2 += d * d;
            }
            if (distance2 < radius2_) offer(map, query, distance2, photon + 3);
            here.node = near;
        }
        visit_leaf(map, query, here.node);
        do {
            if (depth == 0) return;
            here = pending[--depth];
        } while (here.distance2 >= radius2_);
    }
}

void PhotonSearch::visit_leaf(const PhotonMap& map, const PhotonQuery& query, std::uint32_t node) {
    const PhotonMap::Leaf leaf = map.leaf(node);
    const float *const x = leaf.x, *const y = x + leaf.count, *const z = y + leaf.count;
    std::array<float, PhotonMap::largest_leaf> distance2;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const float dx = query.position[0] - x[i], dy = query.position[1] - y[i],
                    dz = query.position[2] - z[i];
        distance2[i] = dx * dx + dy * dy + dz * dz;
    }
    for (std::uint32_t i = 0; i < leaf.count; ++i)
        if (distance2[i] < radius2_) offer(map, query, distance2[i], z + leaf.count + 2 * i);
}

void PhotonSearch::offer(const PhotonMap& map, const PhotonQuery& query, float distance2,
                         const float* attributes) {
    if (!query.accepts(PhotonMap::Attributes(attributes[0], attributes[1]))) return;
    const FoundPhoton photon{distance2, map.word_number(attributes)};
    if (count_ == most_) {
        sift_down(photon);
        radius2_ = found_[0].distance2;
        return;
    }
    std::size_t i = count_++;
    while (i > 0 && found_[(i - 1) / 2].distance2 < distance2) {
        found_[i] = found_[(i - 1) / 2];
        i = (i - 1) / 2;
    }
    found_[i] = photon;
    if (count_ == most_) radius2_ = found_[0].distance2;
}

// In place of the farthest.
void PhotonSearch::sift_down(FoundPhoton photon) {
    std::size_t i = 0;
    for (std::size_t child = 1; child < count_; child = 2 * i + 1) {
        const std::size_t sibling = child + 1 < count_ ? child + 1 : child;
        child += found_[child].distance2 < found_[sibling].distance2 ? 1 : 0;  // without a jump
        if (photon.distance2 >= found_[child].distance2) break;
        found_[i] = found_[child];
        i = child;
    }
    found_[i] = photon;
}

}  // namespace infra
