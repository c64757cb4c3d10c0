#include "ir/plane.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {

Plane plane_of(const Picture& picture, int channel) {
    if (channel >= picture.channels)
        throw Error(formatted("the picture has no channel %d", channel),
                    formatted("its channels are 0 to %d", picture.channels - 1));
    Plane plane{picture.width, picture.height, {}};
    plane.values.reserve(std::size_t(picture.width) * picture.height);
    for (std::size_t first = 0; first < picture.pixels.size(); first += picture.channels) {
        if (channel >= 0) {
            plane.values.push_back(picture.pixels[first + channel]);
            continue;
        }
        double sum = 0;
        for (int c = 0; c < picture.channels; ++c) sum += picture.pixels[first + c];
        plane.values.push_back(static_cast<float>(sum / picture.channels));
    }
    return plane;
}

Picture block_mean(const Picture& picture, int factor) {
    if (factor < 1 || factor > std::min(picture.width, picture.height))
        throw Error(formatted("cannot average blocks of %d pixels in a picture of %d x %d", factor,
                              picture.width, picture.height));
    Picture coarse;
    coarse.width = picture.width / factor;
    coarse.height = picture.height / factor;
    coarse.channels = picture.channels;
    coarse.space = picture.space;
    coarse.header = picture.header;
    coarse.pixels.reserve(std::size_t(coarse.width) * coarse.height * coarse.channels);
    const double share = 1.0 / (double(factor) * factor);
    for (int row = 0; row < coarse.height; ++row) {
        for (int column = 0; column < coarse.width; ++column) {
            for (int c = 0; c < picture.channels; ++c) {
                double sum = 0;
                for (int y = row * factor; y < (row + 1) * factor; ++y)
                    for (int x = column * factor; x < (column + 1) * factor; ++x) sum += picture.at(x, y)[c];
                coarse.pixels.push_back(static_cast<float>(sum * share));
            }
        }
    }
    return coarse;
}

Range finite_range(std::span<const float> values) {
    Range range;
    bool found = false;
    for (const float value : values) {
        if (!std::isfinite(value)) continue;
        range.low = found ? std::min(range.low, value) : value;
        range.high = found ? std::max(range.high, value) : value;
        found = true;
    }
    return range;
}

}  // namespace infra::ir
