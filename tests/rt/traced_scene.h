// Scenes from text, compiled and traced with fixed seeds.
#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "estimate.h"
#include "rt/compile/compiled_scene.h"
#include "rt/tracer.h"
#include "scene/rad_reader.h"

namespace infra::test {

/// Words and numbers (with all their digits) in one text, separated by blanks.
template <class... Parts>
std::string words(const Parts&... parts) {
    std::ostringstream text;
    text.precision(17);
    ((text << parts << ' '), ...);
    return text.str();
}

inline Vec3 direction(double theta, double azimuth) {
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

/// One ray a bounce and Russian roulette below a weight of 0.01: a path tracer that cuts nothing off.
inline RenderSettings path_settings() {
    RenderSettings settings;
    settings.ambient_bounces = 1000;
    settings.ambient_divisions = 1;
    settings.ambient_super_samples = 0;
    settings.specular_threshold = 0;
    settings.max_reflections = 0;
    settings.min_weight = 0.01;
    return settings;
}

/// One bounce of `divisions` rays.
inline RenderSettings bounce_settings(int divisions) {
    RenderSettings settings = path_settings();
    settings.ambient_bounces = 1;
    settings.ambient_divisions = divisions;
    settings.min_weight = 1e-9;
    return settings;
}

/// A uniform surrounding of this radiance, found by rays that miss everything.
inline std::string surrounding(double radiance) {
    return words("void glow surrounding_glow 0 0 4", radiance, radiance, radiance,
                 "0 surrounding_glow source surrounding 0 0 4 0 0 1 360\n");
}

struct RaySpec {
    Vec3 origin, direction;
};

class TracedScene {
  public:
    explicit TracedScene(std::string_view rad, const RenderSettings& settings = {},
                         const Channels& channels = {})
        : settings_(settings) {
        Scene scene;
        read_rad_text(scene, rad, "test.rad", no_warnings());
        compiled_ = CompiledScene::compile(std::move(scene), settings_, channels, {});
        tracer_ = std::make_unique<Tracer>(*compiled_, settings_);
    }

    const CompiledScene& compiled() const { return *compiled_; }
    const RenderSettings& settings() const { return settings_; }
    Tracer& tracer() { return *tracer_; }

    /// What a ray meets first.
    HitState nearest(const Vec3& origin, const Vec3& direction) const {
        HitState state;
        compiled_->geometry().intersect(origin, direction, {}, state);
        return state;
    }
    /// Radiance along one ray, with a random stream of its own.
    Spectrum radiance(const Vec3& origin, const Vec3& direction) {
        tracer_->start_stream(++stream_);
        const Ray ray = tracer_->primary(origin, direction, 0);
        Interaction at(ray);
        tracer_->trace(at);
        return at.radiance;
    }
    /// Irradiance of a surface at `point` that faces along `normal`.
    double irradiance(const Vec3& point, const Vec3& normal) {
        constexpr double lift = 2e-5;  // the imagined surface lies 1e-5 along the ray
        tracer_->start_stream(++stream_);
        const Ray ray = tracer_->primary(point + normal * lift, -normal, 0);
        Interaction at(ray);
        tracer_->irradiance(at);
        return static_cast<double>(at.radiance[0]);
    }

    /// Mean radiance (first channel) of `count` rays, one ray each from next(random) -> RaySpec.
    template <class Next>
    Estimate mean_radiance(int count, const Next& next) {
        RandomStream random(rays_seed, ++stream_);
        Mean mean;
        for (int n = 0; n < count; ++n) {
            const RaySpec ray = next(random);
            mean.add(static_cast<double>(radiance(ray.origin, normalize(ray.direction))[0]));
        }
        return mean.estimate();
    }
    Estimate mean_radiance(int count, const Vec3& origin, const Vec3& along) {
        return mean_radiance(count, [&](RandomStream&) { return RaySpec{origin, along}; });
    }
    /// Mean irradiance of `count` places from next(random) -> RaySpec, a point and a normal.
    template <class Next>
    Estimate mean_irradiance(int count, const Next& next) {
        RandomStream random(rays_seed, ++stream_);
        Mean mean;
        for (int n = 0; n < count; ++n) {
            const RaySpec place = next(random);
            mean.add(irradiance(place.origin, place.direction));
        }
        return mean.estimate();
    }

  private:
    static constexpr std::uint64_t rays_seed = 20010;

    RenderSettings settings_;
    std::shared_ptr<const CompiledScene> compiled_;
    std::unique_ptr<Tracer> tracer_;
    std::uint64_t stream_ = 0;
};

}  // namespace infra::test
