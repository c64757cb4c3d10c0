// One quantity of a picture, a value a pixel: what false colours and temperature scales are made from.
#pragma once

#include <span>
#include <vector>

#include "common/pictures/picture.h"

namespace infra::ir {

/// Row 0 is the top.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// Channel `channel` of a picture, or the mean of its channels when `channel` is negative.
/// throws Error when the picture has no such channel.
Plane plane_of(const Picture& picture, int channel = -1);

/// Channel of a spectral picture whose band holds a wavelength.
/// throws Error when the picture tells no bands or none of them holds it.
int channel_at(const Picture& picture, double wavelength_um);

/// Radiance of a spectral picture in the band of one channel, or in the whole range when `channel` is
/// negative; a picture of one channel, whose BAND line names the band.
/// throws Error when the picture tells no bands or has no such channel.
Picture in_band_radiance(const Picture& picture, int channel);

/// The picture with every block of factor x factor pixels replaced by its mean; columns and rows that fill no
/// block are cut off. A mean of radiances is what a coarser pixel would receive, so this also smooths edges.
/// throws Error unless 1 <= factor <= the smaller side.
Picture block_mean(const Picture& picture, int factor);

/// Least and greatest finite value; both 0 when there is none.
struct Range {
    float low = 0;
    float high = 0;
};
Range finite_range(std::span<const float> values);

}  // namespace infra::ir
