// Rectangles of a picture and the statistics of the pixels in them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/pictures/picture.h"

namespace infra::ir {

/// Pixels x0 <= column < x1, y0 <= row < y1, counted from the upper left corner of the picture.
struct Region {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    std::string label;
};

/// One channel of one region. The standard error of the mean is deviation / sqrt(count) where pixels are
/// independent.
struct Statistics {
    std::size_t count = 0;    ///< of the pixels that the figures are made of
    std::size_t missing = 0;  ///< of those left out, which have no value
    double mean = 0;
    double deviation = 0;  ///< standard deviation of a pixel, with count - 1; 0 for a single pixel
    double minimum = 0;
    double maximum = 0;
};

/// Throws Error for a region that is empty or reaches over the edge of the picture.
void check_region(const Picture& picture, const Region& region);

/// shape: one entry a channel. Pixels that are not finite are left out. throws Error as check_region, and
/// when no pixel of a channel is left.
std::vector<Statistics> region_statistics(const Picture& picture, const Region& region);

}  // namespace infra::ir
