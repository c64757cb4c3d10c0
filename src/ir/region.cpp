#include "ir/region.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {
namespace {

/// Two passes in double: exact enough for a deviation a millionth of the mean.
Statistics channel_statistics(const Picture& picture, const Region& region, int channel) {
    std::vector<double> values;
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x)
            if (const double value = picture.at(x, y)[channel]; std::isfinite(value)) values.push_back(value);
    const std::size_t pixels = std::size_t(region.x1 - region.x0) * (region.y1 - region.y0);
    if (values.empty())
        throw Error(
            formatted("region %s has no pixel with a value in channel %d", region.label.c_str(), channel));
    Statistics result{.count = values.size(), .missing = pixels - values.size()};
    const auto [minimum, maximum] = std::ranges::minmax(values);
    result.minimum = minimum;
    result.maximum = maximum;
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / double(result.count);
    if (result.count < 2) return result;
    double squares = 0;
    for (const double value : values) squares += std::pow(value - result.mean, 2);
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
