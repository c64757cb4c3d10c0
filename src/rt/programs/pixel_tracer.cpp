#include "rt/programs/pixel_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/interrupt.h"
#include "common/views/lens.h"

namespace infra {
namespace {

/// Places of draws that are spread over the samples of a pixel; those of scattering are others.
enum Place : std::uint64_t { in_pixel = 1, on_lens };

}  // namespace

PixelTracer::PixelTracer(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                         Frame& frame)
    : tracer_(scene, settings, settings.seed),
      camera_(camera),
      frame_(frame),
      sample_(scene.channel_count()),
      sum_(scene.channel_count()),
      replicas_(std::size_t{most_replicas} * scene.channels().bands()) {}

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

/// One ray of the stream that the tracer is at, which leaves its radiance in sample_. Returns the distance of
/// what it sees; black and 0 where the view has no ray.
double PixelTracer::trace_sample(int column, int row) {
    const Picture& picture = frame_.picture;
    tracer_.spread(in_pixel);
    const double x = (column + jittered()) / picture.width;
    const double y = (picture.height - 1 - row + jittered()) / picture.height;
    Vec3 origin, direction;
    double reach = 0;
    tracer_.spread(on_lens);
    const bool found = find_ray(x, y, origin, direction, reach);
    tracer_.random().choose_no_more();
    if (!found) {
        std::fill(sample_.begin(), sample_.end(), 0.0f);
        return 0;
    }
    Ray ray = tracer_.primary(origin, direction, std::isfinite(reach) ? reach : 0);
    ray.fore = camera_.view.fore;
    Interaction at(ray);
    tracer_.trace(at);
    if (passed_source(at.surface) >= 0) [[unlikely]]
        return trace_past(at);
    for (int c = 0; c < at.channels(); ++c) sample_[c] = at.radiance[c];
    return at.apparent_distance();
}

/// Standard error of a pixel's mean from how far its replicas are apart.
///   sizes  samples of each replica
double PixelTracer::standard_error(int band, std::span<const int> sizes) const {
    const auto sum_of = [&](std::size_t replica) { return replicas_[replica * frame_.bands() + band]; };
    double sum = 0;
    for (std::size_t r = 0; r < sizes.size(); ++r) sum += sum_of(r);
    const double samples = camera_.samples, mean = sum / samples;
    double squares = 0;
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        const double off = sum_of(r) - sizes[r] * mean;
        squares += off * off;
    }
    const auto count = static_cast<double>(sizes.size());
    return std::sqrt(squares * count / (count - 1)) / samples;
}

bool PixelTracer::trace(int column, int row) {
    const std::size_t index = static_cast<std::size_t>(row) * frame_.picture.width + column;
    if (!frame_.traced.empty() && frame_.is_traced(index)) return false;
    if (camera_.samples == 1 && frame_.error.empty()) {
        throw_if_interrupted();
        tracer_.start_stream(index);
        const double depth = trace_sample(column, row);
        if (!frame_.depth.empty()) frame_.depth[index] = static_cast<float>(depth);
        std::copy(sample_.begin(), sample_.end(), frame_.picture.at(column, row).begin());
    } else {
        trace_samples(column, row, index);
    }
    if (!frame_.traced.empty()) frame_.mark_traced(index);
    return true;
}

/// The mean of a pixel's samples, and its standard error.
void PixelTracer::trace_samples(int column, int row, std::size_t index) {
    const int samples = camera_.samples, replica_count = std::min(samples, most_replicas);
    const std::size_t bands = frame_.bands();
    std::fill(sum_.begin(), sum_.end(), 0.0);
    if (!frame_.error.empty()) std::fill(replicas_.begin(), replicas_.end(), 0.0);
    std::array<int, most_replicas> sizes{};
    for (int s = 0; s < samples; ++s) {
        throw_if_interrupted();
        const std::uint64_t stream = index * static_cast<std::uint64_t>(samples) + s;
        const int replica = s % replica_count, number = s / replica_count;
        if (samples > replica_count)
            tracer_.start_stream(stream, index * most_replicas + replica, static_cast<std::uint32_t>(number));
        else
            tracer_.start_stream(stream);
        const double depth = trace_sample(column, row);
        if (s == 0 && !frame_.depth.empty()) frame_.depth[index] = static_cast<float>(depth);
        for (std::size_t c = 0; c < sample_.size(); ++c) sum_[c] += static_cast<double>(sample_[c]);
        for (std::size_t b = 0; b < bands && !frame_.error.empty(); ++b)
            replicas_[replica * bands + b] += static_cast<double>(frame_.total(sample_, static_cast<int>(b)));
        ++sizes[replica];
    }
    const std::span<float> pixel = frame_.picture.at(column, row);
    for (std::size_t c = 0; c < sum_.size(); ++c) pixel[c] = static_cast<float>(sum_[c] / samples);
    if (!frame_.error.empty())
        for (std::size_t b = 0; b < bands; ++b)
            frame_.error[index * bands + b] = static_cast<float>(
                standard_error(static_cast<int>(b), std::span(sizes).first(replica_count)));
}

}  // namespace infra
