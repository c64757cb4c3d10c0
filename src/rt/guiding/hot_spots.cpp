#include "rt/guiding/hot_spots.h"

#include <algorithm>
#include <span>

namespace infra {
namespace {

/// The ball around all balls of a group, about their box's middle.
HotSpot surround(std::span<const HotSpot> group) {
    Vec3 low(1e30), high(-1e30);
    HotSpot around;
    for (const HotSpot& spot : group) {
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], spot.center[i] - spot.radius);
            high[i] = std::max(high[i], spot.center[i] + spot.radius);
        }
        around.excess += spot.excess;
    }
    around.center = (low + high) * 0.5;
    for (const HotSpot& spot : group)
        around.radius = std::max(around.radius, length(spot.center - around.center) + spot.radius);
    return around;
}

int longest_axis(std::span<const HotSpot> group) {
    Vec3 low(1e30), high(-1e30);
    for (const HotSpot& spot : group)
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], spot.center[i]);
            high[i] = std::max(high[i], spot.center[i]);
        }
    const Vec3 size = high - low;
    const int flat = size.y > size.x ? 1 : 0;
    return size.z > size[flat] ? 2 : flat;
}

struct Group {
    std::span<HotSpot> members;
    HotSpot ball;
    /// How much of what is aimed at it goes astray.
    double looseness() const { return members.size() > 1 ? ball.excess * ball.radius * ball.radius : 0.0; }
};

}  // namespace

std::vector<HotSpot> group_spots(std::vector<HotSpot> balls, int most) {
    if (balls.empty()) return balls;
    std::vector<Group> groups = {{balls, surround(balls)}};
    while (static_cast<int>(groups.size()) < most) {
        const auto loosest =
            std::max_element(groups.begin(), groups.end(),
                             [](const Group& a, const Group& b) { return a.looseness() < b.looseness(); });
        if (loosest->looseness() <= 0) break;
        const std::span<HotSpot> members = loosest->members;
        const int axis = longest_axis(members);
        const std::size_t half = members.size() / 2;
        std::nth_element(
            members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
            [axis](const HotSpot& a, const HotSpot& b) { return a.center[axis] < b.center[axis]; });
        const auto left = members.first(half), right = members.subspan(half);
        *loosest = {left, surround(left)};
        groups.push_back({right, surround(right)});
    }
    std::vector<HotSpot> spots;
    for (const Group& group : groups) spots.push_back(group.ball);
    return spots;
}

}  // namespace infra
