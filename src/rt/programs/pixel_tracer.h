// The radiance of single pixels.
#pragma once

#include <vector>

#include "common/pictures/picture.h"
#include "common/views/view.h"
#include "rt/tracer.h"

namespace infra {

/// A picture while it is computed. Rows count from the top.
struct Frame {
    Picture picture;
    std::vector<float> depth;  ///< distance a pixel; empty when nobody wants it
};

/// Traces pixels of a frame. The value of a pixel is a function of its place alone: neither the order nor the
/// thread in which pixels are traced matters. One per thread; threads may share a frame if they trace
/// different pixels of it.
class PixelTracer {
  public:
    /// jitter: 0..1, share of the pixel over which its sample is spread. `view` is set up; everything
    /// outlives this.
    PixelTracer(const CompiledScene& scene, const RenderSettings& settings, const View& view, double jitter,
                Frame& frame);

    /// Fills in one pixel: black, at distance 0, where the view has no ray.
    ///   throws  Error "interrupted" after a signal
    void trace(int column, int row);

    Tracer& tracer() { return tracer_; }

  private:
    double jittered();

    Tracer tracer_;
    const View& view_;
    double jitter_;
    Frame& frame_;
};

}  // namespace infra
