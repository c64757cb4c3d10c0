#include "rt/materials/bsdf_response.h"

#include <cmath>
#include <numbers>

#include "rt/ray.h"

namespace infra {
namespace {

constexpr double much_finer = 0.12;  // a neighbouring patch of less than this share may be a peak of its own

}  // namespace

void BsdfResponse::add(const Vec3& wi, double omega, Spectrum& result) const {
    const Vec3 to_source = hit_.to_local(wi);
    const double cosine = std::fabs(to_source.z);
    if (cosine <= same_place) return;
    const bool transmits = (to_source.z > 0) != (hit_.viewer.z > 0);
    if (way_ == (transmits ? Way::reflection : Way::transmission)) return;
    const auto scale = static_cast<float>(cosine);
    if (transmits && hit_.aperture.open() && looks_through(to_source, omega)) {
        result.add_scaled(hit_.aperture.surround, scale);
        return;
    }
    if (const ScatterTable* table = transmits ? hit_.transmission() : hit_.reflection())
        add_table(*table, to_source, scale, result);
}

/// Whether the source stands where the rays that pass straight through will find it.
bool BsdfResponse::looks_through(const Vec3& to_source, double omega) const {
    const double dx = to_source.x + hit_.viewer.x, dy = to_source.y + hit_.viewer.y;
    const double size = std::sqrt(omega * std::fabs(to_source.z)) +
                        std::sqrt(hit_.transmission()->least_projected_solid_angle());
    return dx * dx + dy * dy <= 10 * std::numbers::inv_pi * size * size;
}

void BsdfResponse::add_table(const ScatterTable& table, const Vec3& to_source, float scale,
                             Spectrum& result) const {
    const double patch = table.entry(hit_.viewer, to_source).projected_solid_angle;
    Spectrum sum(result.channels());
    int counted = 0;
    for (int n = 0; n < samples_; ++n) {
        const Vec3 in = hit_.jittered_viewer(patch);
        const ScatterEntry entry = table.entry(in, to_source);
        if (entry.value > same_place) {
            if (entry.projected_solid_angle < much_finer * patch) continue;
            sum += hit_.spectrum_of(table, entry, in, to_source);
        }
        ++counted;
    }
    if (counted == 0) return;
    result.add_product(sum * (scale / static_cast<float>(counted)),
                       table.sides().transmits ? hit_.pattern : Spectrum(result.channels(), 1.0f));
}

}  // namespace infra
