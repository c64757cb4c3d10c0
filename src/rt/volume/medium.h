// What fills the space that a ray travels in: it takes radiance away along the ray and scatters that of some
// light sources into it.
//
// The global medium of -me lives in the compiled scene. Any other lives on the stack of the frame that
// crosses into it, and the rays beyond point to it (Ray::medium); where there is nothing they point to
// nothing.
#pragma once

#include "common/spectra/spectrum.h"

namespace infra {

class Channels;
struct RenderSettings;

/// Light sources, by number, whose light a medium scatters into the rays that pass. In the order they came.
class ScatteredSources {
  public:
    static constexpr int capacity = 32;  ///< RADIANCE's; further ones are left out

    bool contains(int source) const;
    /// Does nothing for a source that is there already.
    void add(int source);
    void add(const ScatteredSources& others) {
        for (const int source : others) add(source);
    }
    /// Returns whether it was there.
    bool remove(int source);

    int size() const { return count_; }
    const int* begin() const { return sources_; }
    const int* end() const { return sources_ + count_; }

  private:
    int sources_[capacity];
    int count_ = 0;
};

struct Medium {
    Spectrum extinction;      ///< per scene unit: absorption plus scattering
    Spectrum albedo;          ///< share of the extinction that is scattering, 0..1
    double eccentricity = 0;  ///< of Henyey and Greenstein's function, below 1; 0 or less: isotropic
    ScatteredSources sources;

    explicit Medium(int channels) : extinction(channels), albedo(channels) {}

    /// What a ray weighs after this distance of 1 before, by its least weakened channel; 1 where it hardly
    /// matters.
    double weight_left(double distance) const;

    /// Too thin to matter within any scene.
    bool is_clear() const { return extinction.maximum() <= 1e-10f; }
    /// Whether rays have to be told of it.
    bool matters() const { return !is_clear() || sources.size() > 0; }
    bool scatters() const { return albedo.maximum() > 1e-6f; }

    /// What is left of a radiance after this distance.
    void transmittance(double distance, Spectrum& result) const;
    /// The same for a ray aimed at a light source: what is scattered out of it counts as if it arrived, as in
    /// RADIANCE, for nothing else follows light that is scattered more than once.
    void absorption_alone(double distance, Spectrum& result) const;
};

/// The medium of -me, -ma and -mg. Extinctions below 0 count as 0.
Medium global_medium(const RenderSettings& settings, const Channels& channels);

}  // namespace infra
