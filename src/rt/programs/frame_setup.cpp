#include "rt/programs/frame_setup.h"

#include <algorithm>

namespace infra {

FrameOptions frame_options(const RpictOptions& options, int width, int height, int first_row,
                           IrradianceCache* cache) {
    const int spacing =
        options.samples_per_pixel > 0 ? 1 : std::clamp(options.sample_spacing, 1, widest_spacing);
    return {.width = width,
            .height = height,
            .first_row = first_row,
            .sample_spacing = spacing,
            .sample_contrast = options.sample_contrast,
            .cache = cache};
}

Camera camera_of(const RpictOptions& options, const View& view, const std::optional<View>& previous) {
    return {.view = view,
            .previous = previous,
            .motion_blur = options.motion_blur,
            .lens_diameter = options.lens_diameter,
            .pixel_jitter = options.pixel_jitter,
            .samples = std::max(options.samples_per_pixel, 1)};
}

std::vector<SmallSource> pass_small_sources(const CompiledScene& scene, const RpictOptions& options,
                                            const FrameOptions& size, Camera& camera) {
    const bool blurred = camera.lens_diameter > 0 || (camera.previous && camera.motion_blur > 0);
    if (blurred || !options.render.settings.sources_visible || scene.medium()) return {};
    std::vector<SmallSource> sources =
        find_small_sources(scene, camera.view, size.width, size.height, size.sample_spacing);
    for (const SmallSource& small : sources) {
        const auto surface = static_cast<std::size_t>(scene.source(small.source).surface);
        if (camera.passed_sources.size() <= surface) camera.passed_sources.resize(surface + 1, -1);
        camera.passed_sources[surface] = small.source;
    }
    return sources;
}

}  // namespace infra
