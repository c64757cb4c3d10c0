// Regions drawn into a false-colour picture, as thermal cameras show them: a frame, its label and its mean.
#pragma once

#include "common/pictures/image8.h"
#include "ir/region.h"

namespace infra::ir {

/// Frames a region and writes its label, if any, and `mean` at its upper left corner, in black or white,
/// whichever stands out more against the colours there. `offset` is the row of the image where the picture
/// begins.
void mark_region(Image8& image, const Region& region, double mean, int offset = 0);

}  // namespace infra::ir
