// Which of a file's blocks a table is made of.
#pragma once

#include <string_view>

#include "bsdf/window_element.h"

namespace infra {

inline constexpr ScatterSides all_sides[] = {{true, false}, {false, false}, {true, true}, {false, true}};

/// The last block of a direction and wavelength, nullptr if there is none.
inline const ScatteringBlock* find_block(const WindowElement& element, ScatterSides sides,
                                         std::string_view wavelength) {
    const ScatteringBlock* found = nullptr;
    for (const ScatteringBlock& block : element.blocks)
        if (block.sides.from_front == sides.from_front && block.sides.transmits == sides.transmits &&
            same_name(block.wavelength, wavelength))
            found = &block;
    return found;
}

/// Whether the file has transmission from one side only, which then serves for both by reciprocity.
inline bool transmits_one_way(const WindowElement& element) {
    return !find_block(element, {true, true}, "Visible") || !find_block(element, {false, true}, "Visible");
}

}  // namespace infra
