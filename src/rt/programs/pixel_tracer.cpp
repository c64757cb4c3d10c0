#include "rt/programs/pixel_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/interrupt.h"
#include "common/views/lens.h"

namespace infra {

PixelTracer::PixelTracer(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                         Frame& frame)
    : tracer_(scene, settings, settings.seed),
      camera_(camera),
      frame_(frame),
      sample_(scene.channel_count()),
      mean_(scene.channel_count()),
      total_(scene.channels().bands()),
      deviation_(scene.channels().bands()) {}

/// Place within a pixel, 0.5 is its middle.
double PixelTracer::jittered() { return 0.5 + camera_.pixel_jitter * (0.5 - tracer_.random().uniform()); }

/// The ray at some moment while the shutter is open, half before the view's own time and half after it. The
/// view moves on after it as it has come.
bool PixelTracer::blur_motion(double x, double y, Vec3& origin, Vec3& direction, double& reach) {
    Vec3 earlier_origin, earlier_direction;
    double earlier_reach = 0;
    if (!view_ray(*camera_.previous, x, y, earlier_origin, earlier_direction, earlier_reach)) return true;
    const double back = camera_.motion_blur * (0.5 - tracer_.random().uniform());
    origin += back * (earlier_origin - origin);
    direction += back * (earlier_direction - direction);
    reach += back * (earlier_reach - reach);
    if (std::isnan(reach)) reach = std::numeric_limits<double>::infinity();  // neither has an aft plane
    const double size = length(direction);
    if (!(size > 0)) return false;
    direction /= size;
    return true;
}

/// False where there is none.
bool PixelTracer::find_ray(double x, double y, Vec3& origin, Vec3& direction, double& reach) {
    if (!view_ray(camera_.view, x, y, origin, direction, reach)) return false;
    if (camera_.previous && camera_.motion_blur > 0 && !blur_motion(x, y, origin, direction, reach))
        return false;
    if (!(camera_.lens_diameter > 0)) return true;
    RandomStream& random = tracer_.random();
    const std::array<double, 3> chance{random.uniform(), random.uniform(), random.uniform()};
    return move_on_lens(camera_.view, camera_.lens_diameter, chance, origin, direction);
}

int PixelTracer::passed_source(int surface) const {
    if (surface < 0 || surface >= static_cast<int>(camera_.passed_sources.size())) return -1;
    return camera_.passed_sources[static_cast<std::size_t>(surface)];
}

/// What is behind such a source, or beside one that nothing is behind. Returns its distance.
double PixelTracer::trace_past(const Interaction& source) {
    constexpr int most_passed = 100;
    Ray ray = *source.ray;
    const double fore = ray.fore;
    int surface = source.surface;
    double step = source.distance;
    PlacedShape leaving{source.flat_shape, source.placement};
    for (int passed = 0; passed < most_passed; ++passed) {
        const LightSource& light = tracer_.scene().source(passed_source(surface));
        if (light.distant()) {
            constexpr double beside = 1.01;  // of its radius
            const double sine = std::sqrt(1 - light.least_cosine * light.least_cosine);
            Vec3 outwards = ray.direction - light.center * dot(ray.direction, light.center);
            if (!(length(outwards) > 0)) outwards = cross(light.center, camera_.view.up);
            if (!(length(outwards) > 0)) outwards = camera_.view.image_x;
            ray.direction = normalize(light.center + normalize(outwards) * (beside * sine));
        } else {
            ray.origin += ray.direction * step;
            ray.fore += step;  // the camera stays where it is
            ray.leaving = leaving;
            if (ray.max_distance > 0 && (ray.max_distance -= step) <= 0) break;
        }
        Interaction at(ray);
        tracer_.trace(at);
        surface = at.surface;
        if (passed_source(surface) < 0) {
            for (int c = 0; c < at.channels(); ++c) sample_[c] = at.radiance[c];
            return ray.fore - fore + at.apparent_distance();
        }
        step = at.distance;
        leaving = {at.flat_shape, at.placement};
    }
    std::fill(sample_.begin(), sample_.end(), 0.0f);
    return 0;
}

/// One ray, which leaves its radiance in sample_. Returns the distance of what it sees; black and 0 where the
/// view has no ray.
double PixelTracer::trace_sample(int column, int row, std::uint64_t number) {
    const Picture& picture = frame_.picture;
    std::fill(sample_.begin(), sample_.end(), 0.0f);
    tracer_.start_stream(number);
    const double x = (column + jittered()) / picture.width;
    const double y = (picture.height - 1 - row + jittered()) / picture.height;
    Vec3 origin, direction;
    double reach = 0;
    if (!find_ray(x, y, origin, direction, reach)) return 0;
    Ray ray = tracer_.primary(origin, direction, std::isfinite(reach) ? reach : 0);
    ray.fore = camera_.view.fore;
    Interaction at(ray);
    tracer_.trace(at);
    if (passed_source(at.surface) >= 0) [[unlikely]]
        return trace_past(at);
    for (int c = 0; c < at.channels(); ++c) sample_[c] = at.radiance[c];
    return at.apparent_distance();
}

// Mean and deviation by Welford's recurrence.
void PixelTracer::trace(int column, int row) {
    const std::size_t index = static_cast<std::size_t>(row) * frame_.picture.width + column;
    if (!frame_.traced.empty() && frame_.traced[index]) return;
    const auto samples = static_cast<std::uint64_t>(camera_.samples);
    std::fill(mean_.begin(), mean_.end(), 0.0);
    std::fill(total_.begin(), total_.end(), 0.0);
    std::fill(deviation_.begin(), deviation_.end(), 0.0);
    for (std::uint64_t s = 0; s < samples; ++s) {
        throw_if_interrupted();
        const double depth = trace_sample(column, row, index * samples + s);
        if (s == 0 && !frame_.depth.empty()) frame_.depth[index] = static_cast<float>(depth);
        const auto number = static_cast<double>(s + 1);
        for (std::size_t c = 0; c < sample_.size(); ++c)
            mean_[c] += (static_cast<double>(sample_[c]) - mean_[c]) / number;
        if (frame_.error.empty()) continue;
        for (std::size_t b = 0; b < total_.size(); ++b) {
            const auto value = static_cast<double>(frame_.total(sample_, static_cast<int>(b)));
            const double step = value - total_[b];
            total_[b] += step / number;
            deviation_[b] += step * (value - total_[b]);
        }
    }
    std::ranges::copy(mean_, frame_.picture.at(column, row).begin());
    if (!frame_.error.empty())
        for (std::size_t b = 0; b < deviation_.size(); ++b)
            frame_.error[index * deviation_.size() + b] =
                static_cast<float>(std::sqrt(deviation_[b] / static_cast<double>(samples * (samples - 1))));
    if (!frame_.traced.empty()) frame_.traced[index] = 1;
}

}  // namespace infra
