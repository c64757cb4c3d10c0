#include "rt/volume/medium.h"

#include <algorithm>
#include <cmath>

#include "common/spectra/channels.h"
#include "rt/settings.h"

namespace infra {
namespace {

float remainder(double optical_depth) {
    return optical_depth > 0 ? static_cast<float>(std::exp(-optical_depth)) : 1.0f;
}

}  // namespace

bool ScatteredSources::contains(int source) const { return std::find(begin(), end(), source) != end(); }

void ScatteredSources::add(int source) {
    if (count_ < capacity && !contains(source)) sources_[count_++] = source;
}

bool ScatteredSources::remove(int source) {
    int* const last = sources_ + count_;
    int* const kept = std::remove(sources_, last, source);
    count_ = static_cast<int>(kept - sources_);
    return kept != last;
}

void Medium::transmittance(double distance, Spectrum& result) const {
    for (int c = 0; c < extinction.channels(); ++c)
        result.set(c, remainder(distance * static_cast<double>(extinction[c])));
}

void Medium::absorption_alone(double distance, Spectrum& result) const {
    for (int c = 0; c < extinction.channels(); ++c)
        result.set(c, remainder(distance * static_cast<double>(extinction[c]) *
                                (1.0 - static_cast<double>(albedo[c]))));
}

double Medium::weight_left(double distance) const {
    float least = extinction[0];
    for (int c = 1; c < extinction.channels(); ++c) least = std::min(least, extinction[c]);
    const double optical_depth = distance * static_cast<double>(least);
    return optical_depth > 0.1 ? std::exp(-optical_depth) : 1.0;
}

Medium global_medium(const RenderSettings& settings, const Channels& channels) {
    Medium medium(channels.count());
    const auto& extinction = settings.extinction;
    const auto& albedo = settings.scattering_albedo;
    medium.extinction = channels.from_rgb(std::max(extinction[0], 0.0f), std::max(extinction[1], 0.0f),
                                          std::max(extinction[2], 0.0f));
    medium.albedo = channels.from_rgb(albedo[0], albedo[1], albedo[2]);
    medium.eccentricity = settings.scattering_eccentricity;
    return medium;
}

}  // namespace infra
