#include "rt/programs/tiles.h"

#include <algorithm>

namespace infra {

std::vector<Pass> passes_of(const SampleGrid& grid, int width) {
    const std::vector<int>& rows = grid.rows();
    const bool all_rows = static_cast<int>(rows.size()) == rows.back() - rows.front() + 1;
    const auto is_full = [&](int line) { return static_cast<int>(grid.columns(line).size()) == width; };
    if (all_rows && is_full(0) && is_full(1)) return {Pass::samples};
    return {Pass::samples, Pass::lines, Pass::gaps};
}

std::vector<Tile> tiles_of(const SampleGrid& grid, Pass pass, std::size_t least) {
    const std::size_t lines = grid.rows().size() - (pass == Pass::gaps ? 1 : 0);
    const std::size_t parts_wanted = lines == 0 ? 1 : (least + lines - 1) / lines;
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < lines; ++i) {
        const auto line = static_cast<std::int32_t>(i);
        const std::size_t samples = grid.columns(line).size();
        const std::size_t parts =
            pass == Pass::samples ? std::clamp<std::size_t>(parts_wanted, 1, samples) : 1;
        for (std::size_t k = 0; k < parts; ++k)
            tiles.push_back({line, static_cast<std::int32_t>(samples * k / parts),
                             static_cast<std::int32_t>(samples * (k + 1) / parts)});
    }
    return tiles;
}

std::uint64_t pixels_of(const Tile& tile, const SampleGrid& grid, Pass pass, int width) {
    const auto columns = static_cast<std::uint64_t>(width);
    if (pass == Pass::samples) return static_cast<std::uint64_t>(tile.end - tile.begin);
    if (pass == Pass::lines) return columns - grid.columns(tile.line).size();
    return columns * static_cast<std::uint64_t>(grid.rows()[tile.line + 1] - grid.rows()[tile.line] - 1);
}

}  // namespace infra
