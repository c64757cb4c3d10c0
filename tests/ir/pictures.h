// Small pictures for the tests of this folder.
#pragma once

#include "common/pictures/picture.h"

namespace infra::ir {

/// Channel c of pixel (x, y) is 100 c + 10 y + x.
inline Picture ramp(int width, int height, int channels) {
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.channels = channels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) picture.pixels.push_back(float(100 * c + 10 * y + x));
    return picture;
}

}  // namespace infra::ir
