#include "common/spectra/spectral_color.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace infra {
namespace {

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

}  // namespace

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
    return channels.is_rgb() ? means_of_thirds(channels) : rgb(channels, radiance_primaries());
}

ColorConverter ColorConverter::rgb(const Channels& channels, const Primaries& primaries) {
    if (!channels.is_rgb() && !channels.shows_colors()) return means_of_thirds(channels);
    return through_xyz(channels, adapted_xyz_to_rgb(primaries));
}

ColorConverter ColorConverter::means_of_thirds(const Channels& channels) {
    ColorConverter result(channels);
    const double count = channels.count();
    for (int third = 0; third < 3; ++third)
        for (int c = 0; c < channels.count(); ++c) {
            const double from = std::max(c / count, third / 3.0);
            const double to = std::min((c + 1) / count, (third + 1) / 3.0);
            result.rows_[static_cast<std::size_t>(third)][static_cast<std::size_t>(c)] =
                static_cast<float>(std::max(3 * (to - from), 0.0));
        }
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
