#include "ir/region.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {
namespace {

/// Two passes in double: exact enough for a deviation a millionth of the mean.
Statistics channel_statistics(const Picture& picture, const Region& region, int channel) {
    Statistics result;
    result.minimum = result.maximum = picture.at(region.x0, region.y0)[channel];
    double sum = 0;
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const double value = picture.at(x, y)[channel];
            if (!std::isfinite(value))
                throw Error(formatted("pixel %d %d is not a finite number in channel %d", x, y, channel));
            sum += value;
            result.minimum = std::min(result.minimum, value);
            result.maximum = std::max(result.maximum, value);
            ++result.count;
        }
    }
    result.mean = sum / double(result.count);
    if (result.count < 2) return result;
    double squares = 0;
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x)
            squares += std::pow(picture.at(x, y)[channel] - result.mean, 2);
    result.deviation = std::sqrt(squares / double(result.count - 1));
    return result;
}

}  // namespace

void check_region(const Picture& picture, const Region& region) {
    const std::string corners = formatted("%d %d %d %d", region.x0, region.y0, region.x1, region.y1);
    if (region.x0 >= region.x1 || region.y0 >= region.y1)
        throw Error("region " + corners + " holds no pixel", "give x0 y0 x1 y1 with x0 < x1 and y0 < y1");
    if (region.x0 < 0 || region.y0 < 0 || region.x1 > picture.width || region.y1 > picture.height)
        throw Error("region " + corners + " is not within the picture",
                    formatted("it has %d x %d pixels", picture.width, picture.height));
}

std::vector<Statistics> region_statistics(const Picture& picture, const Region& region) {
    check_region(picture, region);
    std::vector<Statistics> result;
    for (int c = 0; c < picture.channels; ++c) result.push_back(channel_statistics(picture, region, c));
    return result;
}

}  // namespace infra::ir
