#include "rt/programs/pixel_tracer.h"

#include <algorithm>
#include <cmath>

#include "common/interrupt.h"

namespace infra {

PixelTracer::PixelTracer(const CompiledScene& scene, const RenderSettings& settings, const View& view,
                         double jitter, Frame& frame)
    : tracer_(scene, settings), view_(view), jitter_(jitter), frame_(frame) {}

/// Place within a pixel, 0.5 is its middle.
double PixelTracer::jittered() { return 0.5 + jitter_ * (0.5 - tracer_.random().uniform()); }

void PixelTracer::trace(int column, int row) {
    throw_if_interrupted();
    Picture& picture = frame_.picture;
    const std::size_t index = static_cast<std::size_t>(row) * picture.width + column;
    const std::span<float> pixel = picture.at(column, row);
    std::fill(pixel.begin(), pixel.end(), 0.0f);
    if (!frame_.depth.empty()) frame_.depth[index] = 0;

    tracer_.start_stream(index);
    const double x = (column + jittered()) / picture.width;
    const double y = (picture.height - 1 - row + jittered()) / picture.height;
    Vec3 origin, direction;
    double reach = 0;
    if (!view_ray(view_, x, y, origin, direction, reach)) return;

    Ray ray = tracer_.primary(origin, direction, std::isfinite(reach) ? reach : 0);
    ray.fore = view_.fore;
    Interaction at(ray);
    tracer_.trace(at);
    for (int c = 0; c < at.channels(); ++c) pixel[c] = at.radiance[c];
    if (!frame_.depth.empty()) frame_.depth[index] = static_cast<float>(at.apparent_distance());
}

}  // namespace infra
