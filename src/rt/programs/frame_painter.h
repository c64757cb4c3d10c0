// What one thread needs to work on a frame.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "rt/programs/adaptive_sampling.h"
#include "rt/programs/pixel_tracer.h"
#include "rt/programs/tiles.h"

namespace infra {

struct FrameOptions {
    int width = 1;
    int height = 1;
    int first_row = 0;                 ///< rows above it are left as they are
    int sample_spacing = 1;            ///< see SampleGrid; 1 traces every pixel
    double sample_contrast = 0;        ///< see GapFiller
    IrradianceCache* cache = nullptr;  ///< of diffuse interreflection, for all threads; nullptr: none
};

class FramePainter {
  public:
    /// Everything outlives this.
    FramePainter(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                 const FrameOptions& options, const SampleGrid& grid, Frame& frame);
    FramePainter(const FramePainter&) = delete;
    FramePainter& operator=(const FramePainter&) = delete;

    /// Does one piece of work. Pieces of one pass may be done at the same time by painters of the same frame.
    ///   throws  Error "interrupted" after a signal
    void paint(Pass pass, const Tile& tile);

    /// From now on paint() notes the pixels that it traces, by their numbers, at the end of `traced`, and
    /// throws Error "interrupted" before a pixel once `stop` is true. nullptr: no longer.
    void note(std::vector<std::uint64_t>* traced, const std::atomic<bool>* stop);

    Tracer& tracer() { return pixels_.tracer(); }

  private:
    void trace(int column, int row);

    const int width_;
    PixelTracer pixels_;
    GapFiller gaps_;
    std::vector<std::uint64_t>* traced_ = nullptr;
    const std::atomic<bool>* stop_ = nullptr;
};

}  // namespace infra
