#include "rt/programs/render_frame.h"

#include <memory>

#include "rt/programs/adaptive_sampling.h"

namespace infra {
namespace {

/// What one thread needs.
struct Painter {
    PixelTracer pixels;
    GapFiller gaps;

    Painter(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
            const FrameOptions& options, const SampleGrid& grid, Frame& frame)
        : pixels(scene, settings, camera, frame),
          gaps(grid, frame, options.sample_contrast,
               [this](int column, int row) { pixels.trace(column, row); }) {}
    Painter(const Painter&) = delete;
};

}  // namespace

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
                  TracerFaults& faults) {
    if (options.first_row >= options.height) return;
    const SampleGrid grid(options.width, options.height, options.sample_spacing, options.first_row);
    std::vector<std::unique_ptr<Painter>> painters;
    for (int i = 0; i < workers.count(); ++i)
        painters.push_back(std::make_unique<Painter>(scene, settings, camera, options, grid, frame));
    for (const auto& painter : painters) painter->pixels.tracer().use_irradiance_cache(options.cache);

    // Each pass reads only what the one before has finished.
    const int lines = static_cast<int>(grid.rows().size());
    const auto pass = [&](int pieces, auto paint, auto pixels_done) {
        workers.run(pieces, [&](int line, int worker) {
            Tracer& tracer = painters[worker]->pixels.tracer();
            const std::uint64_t rays_before = tracer.ray_count();
            paint(painters[worker]->gaps, line);
            progress.add(pixels_done(line), tracer.ray_count() - rays_before);
        });
    };
    const auto samples_on = [&](int line) { return static_cast<int>(grid.columns(line).size()); };
    pass(
        lines, [](GapFiller& gaps, int line) { gaps.trace_samples(line); }, samples_on);
    pass(
        lines, [](GapFiller& gaps, int line) { gaps.fill_line(line); },
        [&](int line) { return options.width - samples_on(line); });
    pass(
        lines - 1, [](GapFiller& gaps, int line) { gaps.fill_below(line); },
        [&](int line) { return options.width * (grid.rows()[line + 1] - grid.rows()[line] - 1); });

    for (const auto& painter : painters) faults.add(painter->pixels.tracer());
}

}  // namespace infra
