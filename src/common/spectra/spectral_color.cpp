#include "common/spectra/spectral_color.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace infra {
namespace {

constexpr double almost_one = 0.99;  // RADIANCE rounds up counts of bands so
constexpr double rgb_limits_nm[3] = {Channels::red_from_nm, Channels::green_from_nm, Channels::blue_limit_nm};
constexpr EyeResponse observer[3] = {EyeResponse::x, EyeResponse::y, EyeResponse::z};

/// Lower end of channel c in whole nanometres, rounded down as RADIANCE does before it looks up a response.
double lower_whole_nm(const Channels& channels, int c) {
    const double width = (channels.longest_nm() - channels.shortest_nm()) / channels.count();
    return std::floor(channels.shortest_nm() + (channels.count() - 1 - c) * width);
}

/// A colour drawn to the grey of its luminance until no component is negative.
Color within_gamut(const Color& color, float luminance) {
    if (luminance < 0) return {};
    const float lowest = std::min({color[0], color[1], color[2]});
    if (lowest >= 0) return color;
    const float kept = luminance / (luminance - lowest);
    Color result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = std::max(luminance + kept * (color[i] - luminance), 0.0f);
    return result;
}

std::size_t primary(const Channels& channels, int c) {
    return static_cast<std::size_t>(channels.primary_of(c));
}

/// Means over the bands of `channels`, 0 outside the spectrum.
void average(std::span<const double> values, double nm_first, double nm_last, const Channels& channels,
             double* means) {
    const double step = (nm_last - nm_first) / static_cast<double>(values.size());
    const double width = (channels.longest_nm() - channels.shortest_nm()) / channels.count();
    const auto place = [&](double nm) {  // in values, a band one unit long
        return std::clamp((nm - nm_first) / step, 0.0, static_cast<double>(values.size()));
    };
    for (int c = 0; c < channels.count(); ++c) {
        double from = place(channels.upper_nm(c)), to = place(channels.lower_nm(c));
        if (from > to) std::swap(from, to);
        double sum = 0;
        for (std::size_t i = static_cast<std::size_t>(from); static_cast<double>(i) < to; ++i) {
            const double begin = std::max(from, static_cast<double>(i));
            const double end = std::min(to, static_cast<double>(i + 1));
            sum += values[i] * (end - begin);
        }
        means[c] = sum * std::abs(step) / width;
    }
}

/// Colour of a spectrum in equal bands of the range of `bands`, whether or not that reaches all primaries.
Spectrum rgb_of_bands(const Channels& bands, const double* values) {
    Spectrum spectrum(bands.count());
    for (int c = 0; c < bands.count(); ++c) spectrum.set(c, static_cast<float>(values[c]));
    if (bands.count() == 3) return spectrum;
    const Color rgb = ColorConverter::through_xyz(bands, xyz_to_rgb(radiance_primaries()))(spectrum);
    Spectrum result(3);
    for (int c = 0; c < 3; ++c) result.set(c, rgb[static_cast<std::size_t>(c)]);
    return result;
}

}  // namespace

Spectrum resample(const Channels& channels, std::span<const double> values, double nm_first, double nm_last) {
    double means[Channels::most];
    if (!channels.is_rgb()) {
        average(values, nm_first, nm_last, channels, means);
        Spectrum result(channels.count());
        for (int c = 0; c < channels.count(); ++c) result.set(c, static_cast<float>(means[c]));
        return result;
    }
    const int given = static_cast<int>(std::min<std::size_t>(values.size(), Channels::most + 1));
    if (given >= Channels::fewest && given <= Channels::most && nm_first > nm_last && nm_last > 0)
        return rgb_of_bands(Channels::spectral(given, nm_first, nm_last), values.data());
    const double visible_nm = Channels::red_limit_nm - Channels::blue_limit_nm;
    const double bands_per_nm = static_cast<double>(values.size()) / std::abs(nm_first - nm_last);
    const int count = static_cast<int>(
        std::clamp<double>(visible_nm * bands_per_nm + almost_one, Channels::fewest, Channels::most));
    const Channels bands = Channels::spectral(count, Channels::red_limit_nm, Channels::blue_limit_nm);
    average(values, nm_first, nm_last, bands, means);
    return rgb_of_bands(bands, means);
}

Response::Response(const Channels& channels, EyeResponse response) {
    const auto row = std::find(std::begin(observer), std::end(observer), response) - std::begin(observer);
    if (channels.is_rgb() && row < 3) {
        const glm::dmat3 to_xyz = rgb_to_xyz(radiance_primaries());
        for (int c = 0; c < 3; ++c) weights_[static_cast<std::size_t>(c)] = to_xyz[c][static_cast<int>(row)];
        return;
    }
    double above = response_below(response, std::floor(channels.longest_nm()));
    for (int c = 0; c < channels.count(); ++c) {
        const double limit = channels.is_rgb() ? rgb_limits_nm[c] : lower_whole_nm(channels, c);
        const double below = response_below(response, limit);
        weights_[static_cast<std::size_t>(c)] = above - below;
        above = below;
    }
}

double Response::operator()(const Spectrum& spectrum) const {
    double sum = 0;
    for (int c = 0; c < spectrum.channels(); ++c) sum += weights_[static_cast<std::size_t>(c)] * spectrum[c];
    return sum;
}

ColorConverter ColorConverter::xyz(const Channels& channels) {
    ColorConverter result = through_xyz(channels, glm::dmat3(1.0));
    result.keeps_gamut_ = false;
    return result;
}

ColorConverter ColorConverter::rgb(const Channels& channels) {
    return channels.is_rgb() ? means_by_primary(channels) : rgb(channels, radiance_primaries());
}

ColorConverter ColorConverter::rgb(const Channels& channels, const Primaries& primaries) {
    if (!channels.is_rgb() && !channels.shows_colors()) return means_by_primary(channels);
    return through_xyz(channels, adapted_xyz_to_rgb(primaries));
}

ColorConverter ColorConverter::means_by_primary(const Channels& channels) {
    ColorConverter result(channels);
    std::array<float, 3> counts{};
    for (int c = 0; c < channels.count(); ++c) ++counts[primary(channels, c)];
    for (int c = 0; c < channels.count(); ++c)
        result.rows_[primary(channels, c)][static_cast<std::size_t>(c)] = 1 / counts[primary(channels, c)];
    return result;
}

ColorConverter ColorConverter::through_xyz(const Channels& channels, const glm::dmat3& xyz_to_rgb) {
    ColorConverter result(channels);
    const Response x(channels, EyeResponse::x), y(channels, EyeResponse::y), z(channels, EyeResponse::z);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels.count()); ++c) {
        const glm::dvec3 rgb = xyz_to_rgb * glm::dvec3(x.weight(c), y.weight(c), z.weight(c));
        for (std::size_t i = 0; i < 3; ++i) result.rows_[i][c] = static_cast<float>(rgb[static_cast<int>(i)]);
        result.luminance_[c] = static_cast<float>(y.weight(c));
    }
    result.keeps_gamut_ = true;
    return result;
}

Color ColorConverter::operator()(const Spectrum& spectrum) const {
    const auto sum = [&](const Row& row) {
        float total = 0;
        for (int c = 0; c < channels_; ++c) total += row[static_cast<std::size_t>(c)] * spectrum[c];
        return total;
    };
    const Color color = {sum(rows_[0]), sum(rows_[1]), sum(rows_[2])};
    return keeps_gamut_ ? within_gamut(color, sum(luminance_)) : color;
}

}  // namespace infra
