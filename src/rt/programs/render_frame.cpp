#include "rt/programs/render_frame.h"

#include <memory>

namespace infra {

Frame empty_frame(int width, int height, bool with_depth, bool with_error, const Channels& channels) {
    Frame frame;
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    frame.picture.width = width;
    frame.picture.height = height;
    frame.picture.channels = channels.count();
    frame.picture.space = channels.is_rgb() ? ColorSpace::rgb : ColorSpace::spectrum;
    frame.picture.pixels.resize(pixels * channels.count());
    if (with_depth) frame.depth.resize(pixels);
    frame.components = channels.components();
    if (with_error) frame.error.resize(pixels * channels.bands());
    frame.traced.resize(pixels);
    return frame;
}

void render_frame(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                  const FrameOptions& options, Workers& workers, Progress& progress, Frame& frame,
                  Checkpoint* checkpoint, TracerReport& report) {
    if (options.first_row >= options.height) return;
    const SampleGrid grid(options.width, options.height, options.sample_spacing, options.first_row);
    std::vector<std::unique_ptr<FramePainter>> painters;
    for (int i = 0; i < workers.count(); ++i)
        painters.push_back(std::make_unique<FramePainter>(scene, settings, camera, options, grid, frame));
    for (const Pass pass : passes_of(grid, options.width)) {
        const std::vector<Tile> tiles = tiles_of(grid, pass, 0);
        workers.run(static_cast<int>(tiles.size()), [&](int number, int worker) {
            Tracer& tracer = painters[worker]->tracer();
            const std::uint64_t rays_before = tracer.ray_count();
            painters[worker]->paint(pass, tiles[number]);
            progress.add(pixels_of(tiles[number], grid, pass, options.width),
                         tracer.ray_count() - rays_before);
            if (checkpoint) checkpoint->write_if_due();
        });
    }
    for (const auto& painter : painters) report.add(painter->tracer());
}

}  // namespace infra
