// A rough lobe of a material: what is sampled by rays of its own and evaluated for light sources.
//
// A lobe is built for one hit. wi points to where the radiance comes from and leaves the surface; directions
// are in scene coordinates. The lobe's radiance is coefficient * E[weight * L(wi)] over its samples, so that
// `coefficient` is its colour times its directional albedo, and the weights average to 1 (or less, where a
// model loses energy). A lobe whose shape is not the same in all channels is `colored`: then its weight, and
// its eval(), are a mean over the channels, and tint() says what each has of it.
#pragma once

#include <cstdint>

#include "common/random.h"
#include "common/spectra/spectrum.h"
#include "common/vec.h"

namespace infra {

struct LobeDraw {
    Vec3 wi{0, 0, 1};
    double weight = 0;  ///< 0: this sample brings nothing and is not traced
    /// Weight that it would have, had it not gone below the surface. Below 0: what its reflection takes from an
    /// emission that mean_weight() told to be larger.
    double lost = 0;
};

class Lobe {
  public:
    Lobe(std::uint16_t ray_kind, const Spectrum& c) : kind(ray_kind), coefficient(c) {}

    std::uint16_t kind;  ///< reflected_lobe or through_lobe
    Spectrum coefficient;
    /// Samples of no weight are drawn again until `count` are traced, most_redraws draws for each of them.
    bool redraws = false;
    /// The sum of several such samples is divided by the number of draws, not of samples.
    bool counts_draws = false;
    static constexpr int most_redraws = 10;  ///< RADIANCE's: what a steep texture leaves dark depends on it

    bool colored = false;

    /// f |cos| [1/sr] over `coefficient`, for a light source of solid angle omega [sr] around wi; 0 on the
    /// wrong side. Some models widen the lobe by the source's size, as RADIANCE does; omega = 0 gives the
    /// lobe itself.
    virtual double eval(const Vec3& wi, double omega) const = 0;
    /// Sample `index`, from 0, of `count` that together estimate the lobe: they may be stratified.
    virtual LobeDraw sample(RandomStream& random, int index, int count) const = 0;
    /// Density of sample() at wi [1/sr].
    virtual double pdf(const Vec3& wi) const = 0;
    /// Each channel's factor on eval() and on a sample's weight at wi. Asked of colored lobes only.
    virtual void tint(const Vec3&, Spectrum& factor) const { factor.fill(1.0f); }
    /// What the tracer's mean over `count` samples, weights and lost ones together, expects to be: 1 for a
    /// lobe that loses no energy. Its albedo is `coefficient` times this.
    virtual double mean_weight(int) const { return 1; }
    /// Whether the weight of each of `count` samples is eval(wi, 0) / pdf(wi): any other density may then take the
    /// place of some of them.
    virtual bool exact(int) const { return false; }
    /// Number of samples wanted for a ray of this weight, at least 1.
    virtual int sample_count(double ray_weight) const = 0;

  protected:
    ~Lobe() = default;  // lobes live in a Scattering and own nothing
};

}  // namespace infra
