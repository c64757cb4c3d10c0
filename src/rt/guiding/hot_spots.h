// Many small bright things as few balls around them.
#pragma once

#include <vector>

#include "rt/guiding/guide.h"

namespace infra {

/// Groups balls that lie together until at most `most` are left. Their excess adds up.
std::vector<HotSpot> group_spots(std::vector<HotSpot> balls, int most);

}  // namespace infra
