#include "rt/ambient/hemisphere_cells.h"

#include <cstddef>

namespace infra {
namespace {

constexpr double tiny = 1e-6;

}  // namespace

void estimate_variances(std::vector<HemisphereCell>& cells, int n, double norm) {
    const auto cell = [&](int i, int j) -> HemisphereCell& {
        return cells[static_cast<std::size_t>(i * n + j)];
    };
    const auto compare = [&](int i, int j, int k, int l) {
        HemisphereCell &a = cell(i, j), &b = cell(k, l);
        const double difference = a.brightness - b.brightness;
        const double squared = difference * difference * norm / (a.brightness + b.brightness + tiny);
        a.variance += static_cast<float>(squared);
        b.variance += static_cast<float>(squared);
        ++a.neighbours;
        ++b.neighbours;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i) compare(i, j, i - 1, j);
            if (j) compare(i, j, i, j - 1);
            if (i && j) compare(i, j, i - 1, j - 1);
        }
    for (HemisphereCell& c : cells)  // as if all had the six that inner cells have
        if (c.neighbours) c.variance *= 6.0f / static_cast<float>(c.neighbours);
}

}  // namespace infra
