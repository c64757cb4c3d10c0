#include "common/spectra/resampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace infra {
namespace {

constexpr double almost_one = 0.99;  // RADIANCE rounds up counts of bands so

/// Whether RADIANCE makes a colour of the spectrum's own bands.
bool has_bands_for_color(std::size_t count, double nm_first, double nm_last) {
    return count >= Channels::fewest && count <= Channels::most && nm_first > nm_last && nm_last > 0;
}

/// Bands of the visible range about as fine as the spectrum's.
Channels visible_bands(std::size_t count, double nm_first, double nm_last) {
    const double visible_nm = Channels::red_limit_nm - Channels::blue_limit_nm;
    const double bands_per_nm = static_cast<double>(count) / std::abs(nm_first - nm_last);
    const double bands =
        std::clamp<double>(visible_nm * bands_per_nm + almost_one, Channels::fewest, Channels::most);
    return Channels::spectral(static_cast<int>(bands), Channels::red_limit_nm, Channels::blue_limit_nm);
}

}  // namespace

Resampler::Resampler(const Channels& channels, std::size_t count, double nm_first, double nm_last)
    : channels_(channels), bands_(static_cast<std::size_t>(channels.bands())) {
    if (!channels.is_rgb()) {
        add_shares(channels, count, nm_first, nm_last);
        return;
    }
    const bool own = has_bands_for_color(count, nm_first, nm_last);
    const Channels bands = own ? Channels::spectral(static_cast<int>(count), nm_first, nm_last)
                               : visible_bands(count, nm_first, nm_last);
    bands_ = static_cast<std::size_t>(bands.count());
    if (own) {
        for (std::size_t i = 0; i < count; ++i) shares_.push_back({i, i, 1});
    } else {
        add_shares(bands, count, nm_first, nm_last);
    }
    // whether or not the bands reach all primaries
    if (bands_ != 3) color_ = ColorConverter::through_xyz(bands, xyz_to_rgb(radiance_primaries()));
}

void Resampler::add_shares(const Channels& bands, std::size_t count, double nm_first, double nm_last) {
    const double step = (nm_last - nm_first) / static_cast<double>(count);
    const double width = (bands.longest_nm() - bands.shortest_nm()) / bands.bands();
    const auto place = [&](double nm) {  // among the samples, a sample one unit long
        return std::clamp((nm - nm_first) / step, 0.0, static_cast<double>(count));
    };
    for (int c = 0; c < bands.bands(); ++c) {
        double from = place(bands.upper_nm(c)), to = place(bands.lower_nm(c));
        if (from > to) std::swap(from, to);
        for (std::size_t i = static_cast<std::size_t>(from); static_cast<double>(i) < to; ++i) {
            const double begin = std::max(from, static_cast<double>(i));
            const double end = std::min(to, static_cast<double>(i + 1));
            shares_.push_back({i, static_cast<std::size_t>(c), (end - begin) * std::abs(step) / width});
        }
    }
}

Spectrum Resampler::operator()(std::span<const double> values) const {
    double means[Channels::most] = {};
    for (const Share& share : shares_) means[share.band] += share.weight * values[share.sample];
    Spectrum spectrum(static_cast<int>(bands_));
    for (std::size_t c = 0; c < bands_; ++c) spectrum.set(static_cast<int>(c), static_cast<float>(means[c]));
    if (!color_) return channels_.in_all_components(spectrum);
    const Color rgb = (*color_)(spectrum);
    Spectrum result(3);
    for (int c = 0; c < 3; ++c) result.set(c, rgb[static_cast<std::size_t>(c)]);
    return channels_.in_all_components(result);
}

Spectrum resample(const Channels& channels, std::span<const double> values, double nm_first, double nm_last) {
    return Resampler(channels, values.size(), nm_first, nm_last)(values);
}

}  // namespace infra
