#include "rt/materials/bsdf_aperture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double probe_step = 0.6;  // in widths of the smallest patch
constexpr int axis_steps = 4, diagonal_steps = 3;
constexpr std::size_t probe_count = 1 + 4 * (axis_steps + diagonal_steps);
constexpr double largest_patch = 1.5;     // of a peak, over the smallest of the table
constexpr double steepest_fall = 8;       // of a patch below the mean of the peak so far, which ends it
constexpr double least_surround = 0.2;    // solid angle around the peak over its own; all empty patches are
                                          // one, as in RADIANCE: it sees no aperture in a wide peak over none
constexpr double least_through = 0.0005;  // less is not worth a ray

/// What the table holds for a direction near the one straight on.
struct Probe {
    Vec3 direction;
    ScatterEntry entry;
};
using Probes = std::array<Probe, probe_count>;

/// Straight on, and around it along the axes and the diagonals.
Probes probe_around(const BsdfHit& hit, const ScatterTable& table) {
    Probes probes;
    std::size_t count = 0;
    const double step = probe_step * std::sqrt(table.least_projected_solid_angle());
    const auto probe = [&](int i, int j) {
        const Vec3 out = normalize(Vec3{step * i, step * j, 0} - hit.viewer);
        probes[count++] = {out, table.entry(hit.viewer, out)};
    };
    probe(0, 0);
    for (int n = 1; n <= axis_steps; ++n)
        for (const int sign : {-n, n}) {
            probe(sign, 0);
            probe(0, sign);
            if (n > diagonal_steps) continue;
            probe(sign, n);
            probe(sign, -n);
        }
    return probes;
}

}  // namespace

Aperture find_aperture(const BsdfHit& hit) {
    Aperture none(hit.channels.count());
    const ScatterTable* table = hit.transmission();
    if (!table || hit.pattern.maximum() <= 0) return none;
    Probes probes = probe_around(hit, *table);
    std::ranges::stable_sort(probes, [](const Probe& a, const Probe& b) {
        return a.entry.value != b.entry.value ? a.entry.value > b.entry.value : a.entry.cell < b.entry.cell;
    });

    const double lambertian_y = hit.bsdf.lambertian_transmittance(hit.front).y * std::numbers::inv_pi;
    const double smallest = table->least_projected_solid_angle();
    Aperture found(hit.channels.count());
    double peak_angle = 0, surround_angle = 0, peak_sum = 0;
    int peak_patches = 0;
    ScatterEntry last{.value = 1};
    for (const Probe& probe : probes) {
        const bool both_empty = probe.entry.value <= 0 && last.value <= 0;
        if (probe.entry.cell == last.cell || both_empty) continue;
        last = probe.entry;
        const double value = probe.entry.value + lambertian_y;
        const double angle = probe.entry.projected_solid_angle;
        const Spectrum f = hit.spectrum_of(*table, probe.entry, hit.viewer, probe.direction);
        if (angle > largest_patch * smallest || peak_sum > steepest_fall * value * peak_patches) {
            if (peak_patches == 0) return none;
            found.surround.add_scaled(f, static_cast<float>(angle));
            surround_angle += angle;
        } else {
            found.through.add_scaled(f, static_cast<float>(angle));
            peak_angle += angle;
            peak_sum += value;
            ++peak_patches;
        }
    }
    if (surround_angle < least_surround * peak_angle || !(surround_angle > 0)) return none;
    if (peak_sum <= tiny || found.through.brightness() < least_through) return none;
    found.surround *= static_cast<float>(1 / surround_angle);
    found.through *= hit.pattern;
    found.surround *= hit.pattern;
    return found;
}

}  // namespace infra
