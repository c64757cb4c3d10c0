#include "rt/programs/distributed/frame_work.h"

namespace infra {

FrameWork::FrameWork(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                     const FrameOptions& options, Workers& team, Frame& frame)
    : grid(options.width, options.height, options.sample_spacing, options.first_row), workers(team) {
    for (int i = 0; i < workers.count(); ++i)
        painters.push_back(std::make_unique<FramePainter>(scene, settings, camera, options, grid, frame));
}

void FrameWork::fill_lines() {
    const std::vector<Tile> tiles = tiles_of(grid, Pass::lines, 0);
    workers.run(static_cast<int>(tiles.size()),
                [&](int number, int worker) { painters[worker]->paint(Pass::lines, tiles[number]); });
}

TracerReport FrameWork::report() const {
    TracerReport report;
    for (const auto& painter : painters) report.add(painter->tracer());
    return report;
}

}  // namespace infra
