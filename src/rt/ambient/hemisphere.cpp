// Diffuse interreflection: a hemisphere of rays over every point, stratified in equal projected solid angles.
// This is RADIANCE with -aa 0; cached_ambient.cpp stands before it where values are interpolated.
//
// source: Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2 (1997); numbers of rays as
// RADIANCE 6.1.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "rt/ambient/cosine_direction.h"
#include "rt/ambient/hemisphere_cells.h"
#include "rt/guiding/guided_share.h"
#include "rt/scratch.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr int most_divisions = 4096;       // along a side: a hemisphere then has most_samples rays
constexpr int least_cells_for_extra = 49;  // fewer rays say too little of where the differences are

}  // namespace

/// The rays of one hemisphere: where they go and what each brings.
struct Tracer::Hemisphere {
    std::uint16_t kind;
    Vec3 normal, u, v;  ///< frame around the normal with its textures
    Vec3 surface_normal;
    bool tilted;
    int divisions;   ///< along each side of the square
    Spectrum share;  ///< coefficient of one ray
    Ray ray;         ///< each of them but for its direction
    bool steady;     ///< all rays are heavy enough to be traced, so that `ray` serves for all
    std::optional<GuidedShare> guided;

    /// Where a ray for this direction of the textured hemisphere goes: what falls below the surface is turned
    /// back.
    Vec3 turned_back(const Vec3& direction) const {
        const double height = tilted ? dot(direction, surface_normal) : 1.0;
        return height < 0 ? direction - surface_normal * (2.0 * height) : direction;
    }
    /// Density [1/sr] of the rays that are not guided, 0 below the surface.
    double density(const Vec3& wi) const {
        const double height = dot(wi, surface_normal);
        if (height <= 0) return 0;
        double cosines = std::fmax(dot(wi, normal), 0.0);
        if (tilted) cosines += std::fmax(dot(wi - surface_normal * (2.0 * height), normal), 0.0);
        return cosines * std::numbers::inv_pi;
    }
};

void Tracer::add_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side, Interaction& at) {
    if (coefficient.maximum() <= 0) return;
    if (scene_.photons() && add_photons(coefficient, other_side, at)) return;
    const bool computed = settings_.ambient_divisions > 0 &&
                          at.ray->ambient_level < settings_.ambient_bounces &&
                          (at.surface < 0 || scene_.finish(at.surface).in_ambient);
    if (computed && irradiance_cache_) {
        if (add_cached_ambient(coefficient, normal, other_side, at)) return;
    } else if (computed) {
        Hemisphere half{other_side ? through_ambient : reflected_ambient,
                        normal,
                        Vec3{0},
                        Vec3{0},
                        other_side ? -at.normal : at.normal,
                        at.textured(),
                        1,
                        coefficient,
                        Ray(at.channels()),
                        false,
                        std::nullopt};
        make_frame(normal, half.u, half.v);
        Spectrum sum(at.channels());
        if (sample_hemisphere(half, at, sum)) {
            at.radiance += sum;
            return;
        }
    }
    Spectrum average(at.channels());
    at.radiance.add_product(assumed_ambient(average), coefficient);
}

bool Tracer::spawn_ambient(Hemisphere& half, const Interaction& at) {
    if (!spawn(half.ray, half.kind, at, &half.share)) return false;
    half.ray.ambient_level = at.ray->ambient_level + 1;
    return true;
}

// One ray through a point of the unit square that maps to the hemisphere. False if it was not traced.
bool Tracer::trace_ambient(Hemisphere& half, double x, double y, Interaction& at, Spectrum& radiance) {
    if (!half.steady && !spawn_ambient(half, at)) return false;
    Ray& child = half.ray;
    const Vec3 local = cosine_direction(x, y);
    child.direction = half.turned_back(half.u * local.x + half.v * local.y + half.normal * local.z);
    Interaction seen(child);
    trace(seen);
    radiance = seen.radiance * child.coefficient;
    if (half.guided) {
        const double count = half.divisions * half.divisions;
        radiance *= static_cast<float>(
            half.guided->weight_of_others(child.direction, count * half.density(child.direction)));
    }
    return true;
}

// Adds up coefficient times the mean radiance of the hemisphere. False if no ray was heavy enough to be
// traced.
bool Tracer::sample_hemisphere(Hemisphere& half, Interaction& at, Spectrum& sum) {
    const double reflectance = half.share.maximum();
    if (reflectance <= tiny) return false;
    // No more rays than leave each of them above -lw
    const double heaviest =
        0.8 * reflectance * at.weight / (settings_.ambient_divisions * settings_.min_weight + 1e-20);
    const double weight = std::fmin(at.weight, heaviest);
    half.divisions = std::clamp(static_cast<int>(std::sqrt(settings_.ambient_divisions * weight) + 0.5), 1,
                                most_divisions);
    const int cell_count = half.divisions * half.divisions;
    const Spectrum whole = half.share;
    if (guide_) {
        half.guided.emplace(*this, at.point, at.weight);
        guide_hemisphere(half, whole, at, sum);
    }
    half.share *= 1.0f / static_cast<float>(cell_count);
    const double ray_weight = at.weight * half.share.maximum();
    half.steady = ray_weight > settings_.min_weight && half.share.maximum() <= 1;
    if (half.steady && !spawn_ambient(half, at)) return false;

    const int extra =
        static_cast<int>(std::min<double>(settings_.ambient_super_samples * weight + 0.5, most_samples));
    if (extra >= 4 * half.divisions && cell_count > least_cells_for_extra)
        return sample_adaptively(half, extra, at, sum);

    Spectrum radiance(at.channels());
    int traced = 0;
    for (int cell = 0; cell < cell_count; ++cell)
        if (sample_cell(half, cell, at, radiance)) {
            sum += radiance;
            ++traced;
        }
    return traced > 0;
}

// Rays of a hemisphere that go where it is bright.
void Tracer::guide_hemisphere(Hemisphere& half, const Spectrum& coefficient, Interaction& at, Spectrum& sum) {
    const double count = half.divisions * half.divisions;
    Spectrum radiance(at.channels());
    for (int i = 0; i < half.guided->count(); ++i) {
        const Vec3 wi = half.guided->draw();
        const double density = half.density(wi);
        if (!(density > 0)) continue;
        const double share = density / half.guided->total(wi, count * density);
        if (trace_guided(half.kind, coefficient * static_cast<float>(share), wi, at, radiance))
            sum += radiance;
    }
}

// One ray through a random place of a cell.
bool Tracer::sample_cell(Hemisphere& half, int cell, Interaction& at, Spectrum& radiance) {
    const int n = half.divisions;
    const double x = (cell / n + random_.uniform()) / n;
    const double y = (cell % n + random_.uniform()) / n;
    return trace_ambient(half, x, y, at, radiance);
}

// A ray through each cell, then `extra` rays where neighbouring cells differ most.
bool Tracer::sample_adaptively(Hemisphere& half, int extra, Interaction& at, Spectrum& sum) {
    const auto level = static_cast<std::size_t>(at.ray->ambient_level);
    if (scratch_->hemispheres.size() <= level) scratch_->hemispheres.resize(level + 1);
    std::vector<HemisphereCell> cells = std::move(scratch_->hemispheres[level]);
    const int cell_count = half.divisions * half.divisions;
    cells.assign(static_cast<std::size_t>(cell_count), HemisphereCell{Spectrum(at.channels())});
    int traced = 0;
    for (int c = 0; c < cell_count; ++c) {
        HemisphereCell& cell = cells[static_cast<std::size_t>(c)];
        if (!sample_cell(half, c, at, cell.mean)) continue;
        cell.brightness = cell.mean.brightness();
        ++traced;
    }
    if (traced == cell_count) {
        estimate_variances(cells, half.divisions, 1.0 / (half.share.brightness() + tiny));
        double remaining = 0;
        for (const HemisphereCell& cell : cells) remaining += cell.variance;
        Spectrum radiance(at.channels());
        for (int c = 0; c < cell_count && extra > 0 && remaining > tiny; ++c) {
            HemisphereCell& cell = cells[static_cast<std::size_t>(c)];
            const int wanted = static_cast<int>(cell.variance / remaining * extra + random_.uniform());
            remaining -= cell.variance;
            for (int k = 1; k <= wanted && extra > 0; ++k, --extra) {
                if (!sample_cell(half, c, at, radiance)) break;
                cell.mean *= static_cast<float>(k) / static_cast<float>(k + 1);
                cell.mean.add_scaled(radiance, 1.0f / static_cast<float>(k + 1));
            }
        }
    }
    for (const HemisphereCell& cell : cells) sum += cell.mean;
    scratch_->hemispheres[level] = std::move(cells);
    return traced > 0;
}

}  // namespace infra
