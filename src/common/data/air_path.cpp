#include "common/data/air_path.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"

namespace infra {

AirPath::Point AirPath::band_at(int band, double distance) const {
    const std::vector<Node>& nodes = bands_[static_cast<std::size_t>(band)];
    const auto next = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, distance,
                                       [](double d, const Node& node) { return d < node.distance; });
    const Node &a = *(next - 1), &b = *next;
    const double t = (distance - a.distance) / (b.distance - a.distance);
    const double depth = a.depth + t * (b.depth - a.depth);
    const double source = a.source + std::min(t, 1.0) * (b.source - a.source);
    return {std::exp(-depth), -std::expm1(-depth) * source};
}

AirPath::Point AirPath::channel_at(int channel, double distance) const {
    Point sum{0, 0};
    for (const Share& share : shares_[static_cast<std::size_t>(channel)]) {
        const Point at = band_at(share.band, distance);
        sum.transmittance += share.of_channel * at.transmittance;
        sum.radiance += share.of_band * at.radiance;
    }
    return sum;
}

void AirPath::stretch(double near, double far, Spectrum& transmittance, Spectrum& radiance) const {
    transmittance.clear();
    radiance.clear();
    for (int c = 0; c < radiance.channels(); ++c) {
        const Point before = near > 0 ? channel_at(c, near) : Point{1, 0};
        const Point after = channel_at(c, far);
        if (before.transmittance <= 0) continue;  // nothing of it reaches the camera
        transmittance.set(c, static_cast<float>(after.transmittance / before.transmittance));
        radiance.set(c, static_cast<float>((after.radiance - before.radiance) / before.transmittance));
    }
}

void AirPath::share_bands(const Channels& channels, const std::string& name) {
    const int bands = static_cast<int>(bands_.size());
    constexpr double rounding = 1e-6;  // share of a channel that may be left over
    for (int c = 0; c < channels.count(); ++c) {
        std::vector<Share>& shares = shares_[static_cast<std::size_t>(c)];
        if (edges_um_.empty()) {
            shares.push_back({0, 1, 1});
            continue;
        }
        const double lo = channels.is_rgb() ? edges_um_.front() : channels.lower_um(c);
        const double hi = channels.is_rgb() ? edges_um_.back() : channels.upper_um(c);
        const double scale = channels.is_rgb() ? 1 : channels.bands();
        double covered = 0;
        for (int k = 0; k < bands; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const double width = std::min(hi, edges_um_[i + 1]) - std::max(lo, edges_um_[i]);
            if (width <= 0) continue;
            covered += width / (hi - lo);
            shares.push_back({k, width / (hi - lo), scale * width / (edges_um_[i + 1] - edges_um_[i])});
        }
        if (covered < 1 - rounding)
            throw Error(Location{name},
                        formatted("bands of %g-%g um do not cover channel %d, %g-%g um", edges_um_.front(),
                                  edges_um_.back(), c, lo, hi),
                        "-cw must stay within the file's bands");
    }
}

}  // namespace infra
