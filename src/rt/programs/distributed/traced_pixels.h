// Pixels of a frame on their way from one rank to another: exact floats, and all that a pixel has.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rt/programs/distributed/message.h"
#include "rt/programs/pixel_tracer.h"

namespace infra {

/// Numbers of all pixels known to be traced.
std::vector<std::uint64_t> traced_pixels(const Frame& frame);

/// numbers  of traced pixels; fewest bytes if those that follow each other in the frame do so here
void put_pixels(MessageWriter& out, const Frame& frame, std::span<const std::uint64_t> numbers);

/// Adds pixels to a frame of the same size and kind, and returns their numbers.
///   throws  Error for pixels that are not in the frame
std::vector<std::uint64_t> take_pixels(MessageReader& in, Frame& frame);

}  // namespace infra
