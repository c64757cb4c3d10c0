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
    : tracer_(scene, settings), camera_(camera), frame_(frame) {}

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

void PixelTracer::trace(int column, int row) {
    throw_if_interrupted();
    Picture& picture = frame_.picture;
    const std::size_t index = static_cast<std::size_t>(row) * picture.width + column;
    if (!frame_.traced.empty() && frame_.traced[index]) return;
    const std::span<float> pixel = picture.at(column, row);
    std::fill(pixel.begin(), pixel.end(), 0.0f);
    if (!frame_.depth.empty()) frame_.depth[index] = 0;

    tracer_.start_stream(index);
    const double x = (column + jittered()) / picture.width;
    const double y = (picture.height - 1 - row + jittered()) / picture.height;
    Vec3 origin, direction;
    double reach = 0;
    if (find_ray(x, y, origin, direction, reach)) {
        Ray ray = tracer_.primary(origin, direction, std::isfinite(reach) ? reach : 0);
        ray.fore = camera_.view.fore;
        Interaction at(ray);
        tracer_.trace(at);
        for (int c = 0; c < at.channels(); ++c) pixel[c] = at.radiance[c];
        if (!frame_.depth.empty()) frame_.depth[index] = static_cast<float>(at.apparent_distance());
    }
    if (!frame_.traced.empty()) frame_.traced[index] = 1;
}

}  // namespace infra
