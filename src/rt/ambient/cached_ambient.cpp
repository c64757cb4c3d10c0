// Diffuse interreflection where values are interpolated (-aa above 0): look for cached values, or compute a
// new one.
#include <cmath>

#include "rt/ambient/hemisphere_gatherer.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;

/// Russian roulette for the rays of a new value, all or none: a value that lacks some of its rays cannot be
/// kept for others, and where none is kept each bounce multiplies the rays. Makes the hit as heavy as it
/// must be for all of them, until the end.
class RouletteForValue {
  public:
    RouletteForValue(const RenderSettings& settings, RandomStream& random, Interaction& at)
        : at_(at), weight_(at.weight) {
        const double needed = settings.min_weight / HemisphereGatherer::assumed_reflectance;
        if (settings.max_reflections > 0 || at.weight >= needed) return;
        lost_ = random.uniform() * needed >= at.weight;
        at.weight = needed;
    }
    RouletteForValue(const RouletteForValue&) = delete;
    RouletteForValue& operator=(const RouletteForValue&) = delete;
    ~RouletteForValue() { at_.weight = weight_; }

    bool lost() const { return lost_; }
    /// What makes up for the values that were lost.
    double boost() const { return at_.weight / weight_; }

  private:
    Interaction& at_;
    double weight_;
    bool lost_ = false;
};

}  // namespace

/// Looks for opaque surfaces between a hit and other points.
class HitWallTest : public WallTest {
  public:
    HitWallTest(Tracer& tracer, const Interaction& at) : tracer_(tracer), at_(at) {}

    bool hides(const Vec3& point) override {
        const Vec3 way = point - at_.point;
        const double distance = length(way);
        if (!(distance > tiny)) return false;
        Ray ray = tracer_.primary(at_.point, way / distance, distance);
        ray.leaving = {at_.flat_shape, at_.placement};
        ray.lineage |= reflected_shadow;
        while (ray.max_distance > tiny) {
            Interaction seen(ray);
            tracer_.cast(seen);
            if (!seen.hit()) return false;
            const Finish& finish = tracer_.scene().finish(seen.surface);
            if (finish.material && !finish.transparent() && !finish.material->stands_for_others) return true;
            ray.origin = seen.point;
            ray.leaving = {seen.flat_shape, seen.placement};
            ray.max_distance -= seen.distance;
        }
        return false;
    }

  private:
    Tracer& tracer_;
    const Interaction& at_;
};

bool Tracer::add_cached_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side,
                                Interaction& at) {
    IrradiancePlace place{.point = at.point,
                          .normal = other_side ? -at.normal : at.normal,
                          .shading_normal = normal,
                          .level = at.ray->ambient_level,
                          .weight = at.weight};
    HitWallTest walls(*this, at);
    IrradianceValue value(at.channels());
    const double weight = irradiance_cache_->interpolate(place, walls, value.radiance);
    if (weight > tiny) {
        value.radiance *= static_cast<float>(1 / weight);
        at.radiance.add_product(value.radiance, coefficient);
        return true;
    }
    const RouletteForValue roulette(settings_, random_, at);
    place.weight = at.weight;
    HemisphereGatherer gatherer(*this, at, place, other_side ? through_ambient : reflected_ambient);
    if (!gatherer.may_trace()) return false;
    if (roulette.lost()) return true;
    value.radiance.clear();
    switch (gatherer.gather(irradiance_cache_->limits(), value)) {
        case HemisphereGatherer::Outcome::nothing:
            return false;
        case HemisphereGatherer::Outcome::value_only:
            break;
        case HemisphereGatherer::Outcome::complete:
            irradiance_cache_->add(value);
            if (at.textured()) extrapolate(value, place, value.radiance);
            break;
    }
    value.radiance *= static_cast<float>(roulette.boost());
    at.radiance.add_product(value.radiance, coefficient);
    return true;
}

// Where the bounces end: -av, or the logarithmic mean of it (counted -aw times) and all values so far, in its
// colour.
const Spectrum& Tracer::assumed_ambient(Spectrum& average) const {
    const Spectrum& given = scene_.ambient_value();
    const int weight = settings_.ambient_value_weight;
    const std::size_t count = irradiance_cache_ ? irradiance_cache_->lit_values() : 0;
    if (weight <= 0 || count == 0) return given;
    const double absorbed =
        std::log(0.5);  // of the mean: values hold what falls on surfaces, not what leaves them
    const double mean_log = irradiance_cache_->mean_log() + absorbed;
    const double brightness = static_cast<double>(given.brightness());
    if (brightness <= tiny) {
        average.fill(static_cast<float>(std::exp(mean_log)));
        return average;
    }
    const double n = static_cast<double>(count);
    const double blend = (std::log(brightness) * weight + mean_log * n) / (weight + n);
    average = given * static_cast<float>(std::exp(blend) / brightness);
    return average;
}

}  // namespace infra
