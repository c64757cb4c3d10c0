// uvspec's radiances as a dome: by polar angle and, where the file has it, by azimuth.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "common/error.h"
#include "common/format.h"
#include "ir/genirsky/atmosphere.h"

namespace infra::ir {
namespace {

/// Samples by polar angle, for each azimuth.
using AzimuthSamples = std::map<double, std::vector<AngleSample>>;

/// Radiances of the half space that is wanted. Azimuths as uvspec's phi, 0..360.
AzimuthSamples collect(const std::vector<UvspecRadiance>& radiances, bool sky, const Passband& passband) {
    AzimuthSamples samples;
    for (const UvspecRadiance& direction : radiances) {
        if ((direction.umu < 0) != sky) continue;
        const double angle = std::acos(std::abs(direction.umu)) * 180 / std::numbers::pi;
        const double phi = direction.phi ? std::fmod(std::fmod(*direction.phi, 360) + 360, 360) : 0;
        samples[phi].push_back({angle, band_integral(direction.radiance, passband)});
    }
    if (samples.empty() || samples.begin()->second.size() < 2)
        throw Error(sky ? "fewer than 2 downwelling radiances" : "fewer than 2 upwelling radiances",
                    sky ? "a sky needs umu below 0, radiances that come down"
                        : "a sea needs umu above 0, radiances that go up");
    for (auto& [phi, column] : samples) {
        std::ranges::sort(column, {}, &AngleSample::angle_deg);
        const auto twice = std::ranges::adjacent_find(column, {}, &AngleSample::angle_deg);
        if (twice != column.end())
            throw Error(Location{radiances.back().radiance.file},
                        formatted("two radiances %g deg from the pole at phi %g", twice->angle_deg, phi));
    }
    return samples;
}

/// Ten rows at a phi, linear between those given.
std::vector<double> rows_at(const AzimuthSamples& samples, double phi) {
    const bool mirrored = samples.begin()->first == 0 && samples.rbegin()->first == 180;
    if (mirrored && phi > 180) phi = 360 - phi;
    auto after = samples.upper_bound(phi);
    auto before = after == samples.begin() ? std::prev(samples.end()) : std::prev(after);
    if (after == samples.end()) after = mirrored ? before : samples.begin();
    const auto distance = [](double from, double to) { return std::fmod(to - from + 360, 360); };
    const double step = distance(before->first, after->first);
    const double part = step > 0 ? distance(before->first, phi) / step : 0;
    std::vector<double> rows = at_rows(before->second);
    const std::vector<double> next = at_rows(after->second);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] += part * (next[i] - rows[i]);
    return rows;
}

}  // namespace

Dome dome_of_uvspec(const std::vector<UvspecRadiance>& radiances, bool sky, const Passband& passband) {
    const AzimuthSamples samples = collect(radiances, sky, passband);
    if (samples.size() == 1) return {at_rows(samples.begin()->second)};
    Dome dome;
    for (std::size_t column = 0; column < Dome::columns; ++column) {
        // phi is where the sensor looks, clockwise from the south; columns count from the north
        const double phi = std::fmod(Dome::azimuth_deg(column) + 180, 360);
        const std::vector<double> rows = rows_at(samples, phi);
        dome.values.insert(dome.values.end(), rows.begin(), rows.end());
    }
    return dome;
}

}  // namespace infra::ir
