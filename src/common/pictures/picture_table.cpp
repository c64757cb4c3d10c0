#include "common/pictures/picture_table.h"

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

Picture read_checked(const std::string& path) {
    Picture picture = read_float_picture(path);
    if (std::min(picture.width, picture.height) < 2)
        throw Error(Location{path},
                    formatted("a picture of %d x %d pixels is too small", picture.width, picture.height),
                    "at least 2 x 2");
    return picture;
}

/// u and v of a picture.
std::vector<DataAxis> image_axes(const Picture& picture) {
    const double aspect = picture.height * picture.header.pixel_aspect() / picture.width;
    return {DataAxis(0, std::max(1.0, 1 / aspect), static_cast<std::size_t>(picture.width)),
            DataAxis(0, std::max(1.0, aspect), static_cast<std::size_t>(picture.height))};
}

/// The pixels column by column, each from bottom to top, with `channels` values: the picture's, or its only
/// one repeated.
std::vector<float> by_column(const Picture& picture, std::size_t channels) {
    std::vector<float> values;
    values.reserve(picture.pixels.size() / static_cast<std::size_t>(picture.channels) * channels);
    for (int column = 0; column < picture.width; ++column)
        for (int row = picture.height - 1; row >= 0; --row) {
            const std::span<const float> pixel = picture.at(column, row);
            for (std::size_t c = 0; c < channels; ++c) values.push_back(pixel[pixel.size() == 1 ? 0 : c]);
        }
    return values;
}

/// Ends of the range of wavelengths, the longest first.
std::pair<double, double> wavelength_range(const Picture& picture, const std::string& path) {
    const std::vector<std::string> words =
        split_words(picture.header.value("WAVELENGTH_SPLITS").value_or(""));
    if (words.empty() && picture.bands) return {picture.bands->longest_nm(), picture.bands->shortest_nm()};
    double longest = 0, shortest = 0;
    if (words.size() != 4 || !parse_real(words.front(), longest) || !parse_real(words.back(), shortest) ||
        !(shortest > 0) || !(longest > shortest))
        throw Error(Location{path}, "the picture does not say what its wavelengths are",
                    "a line such as WAVELENGTH_SPLITS= 780 588 480 380 in its header");
    return {longest, shortest};
}

}  // namespace

DataTable read_color_table(const std::string& path) {
    const Picture picture = read_checked(path);
    if (picture.space == ColorSpace::spectrum)
        throw Error(Location{path},
                    formatted("a picture of %d channels is not one of colours", picture.channels),
                    "specpict takes spectral pictures");
    if (picture.space == ColorSpace::xyz)
        throw Error(Location{path}, "an XYZ picture where RGB is needed", "convert it with ra_xyze -r");
    std::vector<DataAxis> axes = image_axes(picture);
    axes.emplace_back(0, 2, 3);
    return DataTable(std::move(axes), by_column(picture, 3));
}

DataTable read_spectrum_table(const std::string& path) {
    const Picture picture = read_checked(path);
    if (picture.space != ColorSpace::spectrum || picture.channels < 4)
        throw Error(Location{path}, "this is no spectral picture", "colorpict takes pictures of 3 colours");
    const auto [longest, shortest] = wavelength_range(picture, path);
    const double half_band = 0.5 * (longest - shortest) / picture.channels;
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<DataAxis> axes = image_axes(picture);
    axes.emplace_back(longest - half_band, shortest + half_band, channels);
    return DataTable(std::move(axes), by_column(picture, channels));
}

}  // namespace infra
