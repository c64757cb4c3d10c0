#include "ir/plane.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/pictures/spectral_header.h"

namespace infra::ir {
namespace {

constexpr double nm_per_um = 1000;

const Channels& bands_of(const Picture& picture) {
    if (!picture.bands) throw Error("the picture tells no wavelengths of its channels");
    return *picture.bands;
}

}  // namespace

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

int channel_at(const Picture& picture, double wavelength_um) {
    const Channels& bands = bands_of(picture);
    const double nm = wavelength_um * nm_per_um;
    for (int c = 0; c < bands.count(); ++c)
        if (nm <= bands.upper_nm(c) && nm >= bands.lower_nm(c)) return c;
    throw Error(formatted("the picture has no channel at %g um", wavelength_um),
                "-wl is in um; the picture's range is " + band_in_um(bands));
}

Picture in_band_radiance(const Picture& picture, int channel) {
    const Channels& bands = bands_of(picture);
    Plane plane = plane_of(picture, channel);
    if (channel >= 0)
        for (float& value : plane.values) value /= static_cast<float>(bands.count());
    Picture result{plane.width, plane.height, 1, ColorSpace::rgb, std::move(plane.values), picture.header,
                   {}};
    set_channel_lines(result.header, Channels());
    std::erase_if(result.header.lines, [](const std::string& line) { return line.starts_with("BAND="); });
    result.header.add("BAND= " + (channel < 0 ? band_in_um(bands) : band_in_um(bands, channel)));
    return result;
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
    coarse.bands = picture.bands;
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
