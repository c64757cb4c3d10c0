// The work on a picture in pieces that can be done in any order, by anyone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rt/programs/adaptive_sampling.h"

namespace infra {

/// Each pass reads only what the ones before have finished.
enum class Pass {
    samples,  ///< the samples on base lines
    lines,    ///< the rest of base lines
    gaps      ///< the rows between a base line and the next
};

/// One piece of a pass: a base line and, in Pass::samples, the numbers of the samples on it.
struct Tile {
    std::int32_t line = 0;
    std::int32_t begin = 0, end = 0;
};

/// The passes that a picture needs: one where every pixel is a sample.
///   width  of the picture
std::vector<Pass> passes_of(const SampleGrid& grid, int width);

/// All pieces of a pass.
///   least  as many as this, if lines can be cut into so many; samples can, the work of other passes goes on
///          from pixel to pixel along a line
std::vector<Tile> tiles_of(const SampleGrid& grid, Pass pass, std::size_t least);

/// Pixels that are done with a piece, of a picture this wide.
std::uint64_t pixels_of(const Tile& tile, const SampleGrid& grid, Pass pass, int width);

}  // namespace infra
