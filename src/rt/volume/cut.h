// What antimatter has taken out of a ray's way.
#pragma once

#include <algorithm>
#include <vector>

#include "scene/scene.h"

namespace infra {

/// One crossing of an antimatter surface, on the stack of the frame that crosses. The crossings of a ray make
/// a list, the last one first.
struct Cut {
    const Cut* before;                          ///< nullptr: none
    const std::vector<PrimitiveId>& modifiers;  ///< of the surfaces it takes away, sorted
    bool entering;                              ///< else it gives them back

    /// Whether surfaces of this modifier are not there: the last crossing that speaks of them decides.
    bool removes(PrimitiveId modifier) const {
        for (const Cut* cut = this; cut; cut = cut->before)
            if (std::binary_search(cut->modifiers.begin(), cut->modifiers.end(), modifier))
                return cut->entering;
        return false;
    }
};

}  // namespace infra
