#include "common/pictures/spectral_exr.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/format.h"
#include "common/parse_number.h"

namespace infra {
namespace {

constexpr std::string_view prefix = "S0.";

struct Unit {
    std::string_view name;
    double nm;
};
constexpr Unit units[] = {{"nm", 1}, {"um", 1e3}, {"mm", 1e6}, {"m", 1e9}};

/// Wavelength of a channel, nothing when it is not spectral.
std::optional<double> wavelength_nm(std::string_view name) {
    if (!name.starts_with(prefix)) return std::nullopt;
    name.remove_prefix(prefix.size());
    for (const Unit& unit : units) {
        if (!name.ends_with(unit.name)) continue;
        std::string number(name.substr(0, name.size() - unit.name.size()));
        std::ranges::replace(number, ',', '.');
        double value = 0;
        if (parse_real(number, value) && value > 0 && std::isfinite(value)) return value * unit.nm;
    }
    return std::nullopt;
}

}  // namespace

std::string spectral_channel_name(double nm) {
    std::string number = formatted("%.3f", nm);
    std::ranges::replace(number, '.', ',');
    return std::string(prefix) + number + "nm";
}

std::vector<SpectralChannel> spectral_channels(const std::vector<std::string>& names) {
    std::vector<SpectralChannel> channels;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const auto nm = wavelength_nm(names[i])) channels.push_back({i, *nm});
    std::ranges::stable_sort(channels, std::ranges::greater(), &SpectralChannel::nm);
    return channels;
}

std::optional<Channels> bands_around(const std::vector<SpectralChannel>& channels) {
    const int count = static_cast<int>(std::min<std::size_t>(channels.size(), Channels::most + 1));
    if (count < Channels::fewest || count > Channels::most) return std::nullopt;
    const double step = (channels.front().nm - channels.back().nm) / (count - 1);
    for (std::size_t c = 1; c < channels.size(); ++c)
        if (std::abs(channels[c - 1].nm - channels[c].nm - step) > 1e-3 * step) return std::nullopt;
    const double longest = channels.front().nm + step / 2, shortest = channels.back().nm - step / 2;
    if (!(step > 0) || !(shortest > 0)) return std::nullopt;
    return Channels::spectral(count, longest, shortest);
}

}  // namespace infra
