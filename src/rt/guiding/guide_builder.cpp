// What stands out in a scene: its sky is looked at in every direction, each emitting surface along a few
// lines.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/compile/compiled_scene.h"
#include "rt/guiding/cone_direction.h"
#include "rt/guiding/guide.h"
#include "rt/guiding/hot_spots.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint64_t seed = 0x9a1de;
constexpr int glances = 4096;  // for the mean radiance
constexpr int lines_a_surface = 16;
constexpr int looks_at_a_sun = 64;
constexpr double smallest_sky = 0.2;   // [sr]: distant sources below this are spots
constexpr double standing_out = 1.5;   // times the mean radiance
constexpr double worth_aiming = 0.05;  // of the sky's light

class GuideBuilder {
  public:
    GuideBuilder(const CompiledScene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(without_bounces(settings)), tracer_(scene, settings_, seed) {}

    std::unique_ptr<const Guide> build() {
        mean_ = mean_radiance();
        std::vector<double> sky(DirectionMap::cells);
        double sky_mean = 0, sky_excess = 0;
        for (int cell = 0; cell < DirectionMap::cells; ++cell)
            sky_mean += (sky[static_cast<std::size_t>(cell)] = sky_radiance(cell)) / DirectionMap::cells;
        for (double& radiance : sky) {
            radiance = std::max(0.0, radiance - standing_out * sky_mean);
            sky_excess += radiance * DirectionMap::cell_size;
        }
        if (sky_excess <= worth_aiming * 4 * pi * sky_mean) sky_excess = 0;
        std::vector<HotSpot> spots = suns();
        const std::vector<HotSpot> hot =
            group_spots(hot_surfaces(), Guide::most_spots - static_cast<int>(spots.size()));
        spots.insert(spots.end(), hot.begin(), hot.end());
        if (sky_excess == 0 && spots.empty()) return nullptr;
        return std::make_unique<Guide>(sky_excess > 0 ? DirectionMap(sky) : DirectionMap(), sky_excess,
                                       std::move(spots));
    }

  private:
    static RenderSettings without_bounces(RenderSettings settings) {
        settings.ambient_bounces = 0;
        settings.irradiance = false;
        for (float& value : settings.ambient_value) value = 0;
        return settings;
    }

    /// A ray as those that gather indirect light: what is aimed at as a source is dark for it.
    Ray gathering_ray(const Vec3& origin, const Vec3& direction) {
        Ray ray = tracer_.primary(origin, direction, 0);
        ray.kind = reflected_ambient;
        ray.lineage |= reflected_ambient;
        return ray;
    }

    Vec3 random_direction() {
        const double u = tracer_.random().uniform(), v = tracer_.random().uniform();
        return cone_direction(Vec3(0, 0, 1), -1, u, v);
    }

    /// Of all directions, seen from places all over the scene.
    double mean_radiance() {
        const Bounds& box = scene_.geometry().bounds();
        tracer_.start_stream(0);
        double sum = 0;
        for (int i = 0; i < glances; ++i) {
            Vec3 place(0);
            for (int k = 0; k < 3 && !box.empty(); ++k)
                place[k] = box.lo[k] + (box.hi[k] - box.lo[k]) * tracer_.random().uniform();
            const Ray ray = gathering_ray(place, random_direction());
            Interaction at(ray);
            tracer_.trace(at);
            sum += static_cast<double>(at.radiance.brightness());
        }
        return sum / glances;
    }

    /// Of what stands at infinity; small sources, which are spots, left out.
    double sky_radiance(int cell) {
        constexpr double places[2] = {0.25, 0.75};
        double sum = 0;
        for (const double u : places)
            for (const double v : places) {
                const Ray ray = gathering_ray(Vec3(0), DirectionMap::direction(cell, u, v));
                Interaction at(ray);
                tracer_.view_sky(at);
                const bool is_spot = at.hit() && is_sun(scene_.source(scene_.surface(at.surface).source));
                if (!is_spot) sum += static_cast<double>(at.radiance.brightness());
            }
        return sum / 4;
    }

    static bool is_sun(const LightSource& source) { return source.skip && source.size < smallest_sky; }

    std::vector<HotSpot> suns() {
        std::vector<HotSpot> found;
        for (const int number : scene_.distant_sources()) {
            const LightSource& source = scene_.source(number);
            if (!is_sun(source) || found.size() == Guide::most_spots / 2) continue;
            tracer_.start_stream(1 + static_cast<std::uint64_t>(number));
            double sum = 0;
            for (int i = 0; i < looks_at_a_sun; ++i) {
                const double u = tracer_.random().uniform(), v = tracer_.random().uniform();
                const Ray ray =
                    gathering_ray(Vec3(0), cone_direction(source.center, source.least_cosine, u, v));
                Interaction at(ray);
                tracer_.view_sky(at);
                sum += static_cast<double>(at.radiance.brightness());
            }
            const double radiance = sum / looks_at_a_sun;
            if (radiance > standing_out * mean_)
                found.push_back({source.center, source.least_cosine, (radiance - mean_) * source.size, true});
        }
        return found;
    }

    /// The balls around surfaces that are brighter than the rest. Lines through a ball that are drawn evenly
    /// meet the surface in proportion to its mean projected area.
    std::vector<HotSpot> hot_surfaces() {
        std::vector<HotSpot> found;
        for (const CompiledScene::EmittingSurface& emitting : scene_.emitting_surfaces()) {
            tracer_.start_stream(static_cast<std::uint64_t>(emitting.surface) << 20);
            double sum = 0;
            int met = 0;
            for (int i = 0; i < lines_a_surface; ++i) {
                const Vec3 along = random_direction();
                Vec3 x, y;
                make_frame(along, x, y);
                const double turn = 2 * pi * tracer_.random().uniform();
                const double off = emitting.radius * std::sqrt(tracer_.random().uniform());
                const Vec3 start = emitting.center - along * (2 * emitting.radius) +
                                   x * (off * std::cos(turn)) + y * (off * std::sin(turn));
                const Ray ray = gathering_ray(start, along);
                Interaction at(ray);
                if (!tracer_.meet(emitting.surface, at)) continue;
                ++met;
                tracer_.shade_chain(scene_.finish(emitting.surface).modifier, at);
                sum += static_cast<double>(at.radiance.brightness());
            }
            if (met == 0 || !(sum > standing_out * mean_ * met)) continue;
            const double disk = pi * emitting.radius * emitting.radius;
            found.push_back(
                {emitting.center, emitting.radius, (sum - mean_ * met) / lines_a_surface * disk, false});
        }
        return found;
    }

    const CompiledScene& scene_;
    RenderSettings settings_;
    Tracer tracer_;
    double mean_ = 0;
};

}  // namespace

std::unique_ptr<const Guide> Guide::build(const CompiledScene& scene, const RenderSettings& settings) {
    return GuideBuilder(scene, settings).build();
}

}  // namespace infra
