#include "rt/programs/frame_painter.h"

#include "common/error.h"

namespace infra {

FramePainter::FramePainter(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                           const FrameOptions& options, const SampleGrid& grid, Frame& frame)
    : width_(options.width),
      pixels_(scene, settings, camera, frame),
      gaps_(grid, frame, options.sample_contrast, [this](int column, int row) { trace(column, row); }) {
    pixels_.tracer().use_irradiance_cache(options.cache);
}

void FramePainter::trace(int column, int row) {
    if (stop_ && stop_->load(std::memory_order_relaxed)) throw Error("interrupted", {}, Severity::internal);
    if (pixels_.trace(column, row) && traced_)
        traced_->push_back(static_cast<std::uint64_t>(row) * width_ + column);
}

void FramePainter::paint(Pass pass, const Tile& tile) {
    switch (pass) {
        case Pass::samples:
            gaps_.trace_samples(tile.line, tile.begin, tile.end);
            break;
        case Pass::lines:
            gaps_.fill_line(tile.line);
            break;
        case Pass::gaps:
            gaps_.fill_below(tile.line);
            break;
    }
}

void FramePainter::note(std::vector<std::uint64_t>* traced, const std::atomic<bool>* stop) {
    traced_ = traced;
    stop_ = stop;
}

}  // namespace infra
