#include "rt/compile/scene_bands.h"

#include "common/format.h"

namespace infra {
namespace {

constexpr double rounding = 1e-6;  // relative, of a wavelength

std::string words(const SceneBands::Band& band) { return formatted("%g-%g um", band.first, band.second); }

bool same(double a, double b) { return a - b <= rounding * b && b - a <= rounding * b; }

/// What a spectral rendering shows of a band; empty for all of it.
std::string darkness(const SceneBands::Band& band, const Channels& channels) {
    const SceneBands::Band range = {channels.lower_um(channels.bands() - 1), channels.upper_um(0)};
    if (range.second <= band.first || range.first >= band.second)
        return "thermal surfaces of " + words(band) + " are dark in channels of " + words(range) +
               " (-cw is in nanometres)";
    const bool covered = (range.first >= band.first || same(range.first, band.first)) &&
                         (range.second <= band.second || same(range.second, band.second));
    if (covered) return {};
    return "thermal surfaces of " + words(band) + " are dark in a part of the channels' " + words(range);
}

}  // namespace

std::optional<SceneBands::Band> SceneBands::common() const {
    if (bands_.size() != 1) return std::nullopt;
    return *bands_.begin();
}

std::vector<std::string> SceneBands::warnings(const Channels& channels, const AirPath* air) const {
    std::vector<std::string> result;
    if (!channels.is_rgb()) {
        for (const Band& band : bands_)
            if (std::string text = darkness(band, channels); !text.empty()) result.push_back(std::move(text));
        return result;
    }
    if (bands_.size() > 1)
        result.push_back("thermal surfaces of " + words(*bands_.begin()) + " and of " +
                         words(*bands_.rbegin()) + " in one rendering (-cs and -cw render channels of both)");
    if (air && !air->edges_um().empty())
        for (const Band& band : bands_)
            if (!same(band.first, air->edges_um().front()) || !same(band.second, air->edges_um().back()))
                result.push_back("air of " + words({air->edges_um().front(), air->edges_um().back()}) +
                                 " before thermal surfaces of " + words(band));
    return result;
}

}  // namespace infra
