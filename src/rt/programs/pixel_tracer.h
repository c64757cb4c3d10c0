// The radiance of single pixels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/pictures/picture.h"
#include "common/views/view.h"
#include "rt/tracer.h"

namespace infra {

/// A picture while it is computed. Rows count from the top.
struct Frame {
    Picture picture;
    std::vector<float> depth;  ///< distance a pixel; empty when nobody wants it
    std::vector<float> error;  ///< standard error a pixel and band; empty when nobody wants it
    int components = 1;        ///< of every band, in the picture: its radiance is their sum
    /// A byte a pixel: 1 if its value was traced, and so is known, not interpolated. Empty when nobody asks.
    std::vector<std::uint8_t> traced;

    int bands() const { return picture.channels / components; }
    /// Sum over the components of one pixel's values.
    float total(std::span<const float> values, int band) const {
        float sum = values[band];
        for (std::size_t c = band + bands(); c < values.size(); c += bands()) sum += values[c];
        return sum;
    }

    /// For threads that look on while others trace: what is marked as traced has all its values.
    bool is_traced(std::size_t index) const { return __atomic_load_n(&traced[index], __ATOMIC_ACQUIRE) != 0; }
    void mark_traced(std::size_t index) {
        __atomic_store_n(&traced[index], std::uint8_t{1}, __ATOMIC_RELEASE);
    }
};

/// Where the rays of a pixel start and go.
struct Camera {
    View view;                     ///< set up
    std::optional<View> previous;  ///< of the picture before, set up: what motion is measured from
    double motion_blur = 0;        ///< share of the time between two pictures that the shutter is open
    double lens_diameter = 0;      ///< scene units; in focus is what lies at the view's distance
    /// By surface: a light source that its rays pass as if it were not there, or -1. Surfaces beyond the end
    /// are seen.
    std::vector<int> passed_sources;
    double pixel_jitter = 0;  ///< 0..1, share of the pixel over which its sample is spread
    int samples = 1;          ///< of a pixel, whose mean it is; in replicas, see PixelTracer
};

/// Traces pixels of a frame. The value of a pixel is a function of its place alone: neither the order nor the
/// thread in which pixels are traced matters. One per thread; threads may share a frame if they trace
/// different pixels of it.
///
/// The samples of a pixel are up to 16 replicas of a sequence of low discrepancy, independent of each other:
/// what samples of one replica have in common makes their mean better than that of independent samples, and
/// what their error is shows in how the replicas' means differ.
class PixelTracer {
  public:
    static constexpr int most_replicas = 16;

    /// Everything outlives this.
    PixelTracer(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                Frame& frame);

    /// Fills in one pixel, unless it is known: black, at distance 0, where the view has no ray.
    ///   returns  whether it was not known
    ///   throws   Error "interrupted" after a signal
    bool trace(int column, int row);

    Tracer& tracer() { return tracer_; }

  private:
    double jittered();
    void trace_samples(int column, int row, std::size_t index);
    double trace_sample(int column, int row);
    double standard_error(int band, std::span<const int> sizes) const;
    bool find_ray(double x, double y, Vec3& origin, Vec3& direction, double& reach);
    int passed_source(int surface) const;
    double trace_past(const Interaction& source);
    bool blur_motion(double x, double y, Vec3& origin, Vec3& direction, double& reach);

    Tracer tracer_;
    const Camera& camera_;
    Frame& frame_;
    std::vector<float> sample_;     // the last one
    std::vector<double> sum_;       // of a pixel's samples
    std::vector<double> replicas_;  // sums over a replica's samples and the components: replicas x bands
};

}  // namespace infra
