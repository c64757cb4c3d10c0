// Diffuse interreflection: a hemisphere of rays over every point, stratified in equal projected solid angles.
// This is RADIANCE with -aa 0; cached_ambient.cpp stands before it where values are interpolated.
//
// source: Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2 (1997); numbers of rays as
// RADIANCE 6.1.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "rt/ambient/aimed_rays.h"
#include "rt/ambient/hemisphere_cells.h"
#include "rt/ambient/tilt.h"
#include "rt/guiding/guided_share.h"
#include "rt/scratch.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr int most_divisions = 4096;       // along a side: a hemisphere then has most_samples rays
constexpr int least_cells_for_extra = 49;  // fewer rays say too little of where the differences are
constexpr int least_divisions_for_tilt = 7;
constexpr int most_redraws = 10;

}  // namespace

/// The rays of one hemisphere: where they go and what each brings.
struct Tracer::Hemisphere {
    std::uint16_t kind;
    Vec3 normal;  ///< with its textures
    Vec3 surface_normal;
    bool textured;
    Vec3 u, v, axis;           ///< frame that the rays are drawn in
    std::optional<Tilt> tilt;  ///< what weighs them, where the axis is not the normal
    double weight = 1;         ///< of the last ray
    int divisions = 1;         ///< along each side of the square
    Spectrum share;            ///< coefficient of one ray
    Ray ray;                   ///< each of them but for its direction
    bool steady = false;       ///< all rays are heavy enough to be traced, so that `ray` serves for all
    std::optional<GuidedShare> guided;

    void lay_frame();
    double balance(int traced, double weights) const;
    double density(const Vec3& wi) const;
    double share_of(const Vec3& wi) const;
    Vec3 to_scene(const Vec3& local) const { return u * local.x + v * local.y + axis * local.z; }
};

// Many rays over a textured surface fill the hemisphere over the true one and are weighted; few, whose sum
// could be negative then, are drawn around the turned normal and again if they fall below the surface. Even
// light gives the same with a texture as without in both cases.
void Tracer::Hemisphere::lay_frame() {
    const bool weighted = textured && divisions >= least_divisions_for_tilt;
    axis = weighted ? surface_normal : normal;
    make_frame(axis, u, v);
    if (weighted) tilt.emplace(dot(normal, u), dot(normal, v));
}

// Of the rays that are not guided, all together [1/sr].
double Tracer::Hemisphere::density(const Vec3& wi) const {
    const double height = dot(wi, surface_normal);
    if (height <= 0) return 0;
    const double count = divisions * divisions;
    if (tilt) return count * tilt->density({0, 0, height});
    // Of a hemisphere around the turned normal so much is above the surface.
    const double above = textured ? 0.5 * (1 + dot(normal, surface_normal)) : 1.0;
    return count * std::max(dot(wi, normal), 0.0) * std::numbers::inv_pi / above;
}

// What radiance from there counts for in the mean over the hemisphere [1/sr].
double Tracer::Hemisphere::share_of(const Vec3& wi) const {
    const double even = density(wi) / (divisions * divisions);
    return tilt && even > 0 ? even * tilt->weight({dot(wi, u), dot(wi, v), dot(wi, axis)}) : even;
}

// Weights have a mean of 1. Divided by what these came to, even light is free of noise.
double Tracer::Hemisphere::balance(int traced, double weights) const {
    return tilt && traced > 0 && weights > 0.5 * traced ? traced / weights : 1.0;
}

void Tracer::add_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side, Interaction& at) {
    if (coefficient.maximum() <= 0) return;
    if (scene_.photons() && add_photons(coefficient, other_side, at)) return;
    const bool computed = settings_.ambient_divisions > 0 &&
                          at.ray->ambient_level < settings_.ambient_bounces &&
                          (at.surface < 0 || scene_.finish(at.surface).in_ambient);
    if (computed && irradiance_cache_) {
        if (add_cached_ambient(coefficient, normal, other_side, at)) return;
    } else if (computed) {
        Hemisphere half{.kind = other_side ? through_ambient : reflected_ambient,
                        .normal = normal,
                        .surface_normal = other_side ? -at.normal : at.normal,
                        .textured = at.textured(),
                        .share = coefficient,
                        .ray = Ray(at.channels())};
        Spectrum sum(at.channels());
        const bool traced = sample_hemisphere(half, at, sum);
        const bool by_chance = settings_.max_reflections <= 0;  // that no ray was traced
        if (traced || (half.guided && by_chance)) {
            if (half.guided) guide_hemisphere(half, coefficient, at, sum);
            // What lies in the direction that a normal turns away from takes no more than there is.
            for (int c = 0; half.tilt && c < sum.channels(); ++c) sum.set(c, std::max(0.0f, sum[c]));
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

// Ray number `aimed` of a few. False if it was not traced.
bool Tracer::trace_ambient(Hemisphere& half, const AimedRays& rays, int aimed, Interaction& at,
                           Spectrum& radiance) {
    if (!half.steady && !spawn_ambient(half, at)) return false;
    Ray& child = half.ray;
    if (half.tilt) [[unlikely]] {
        const Vec3 local = half.tilt->direction(rays.across[0][aimed], rays.across[1][aimed]);
        half.weight = half.tilt->weight(local);
        child.direction = half.to_scene(local);
    } else {
        child.direction = rays[aimed];
        if (half.textured) turn_upwards(half, child.direction);
    }
    double share = 1;
    if (half.guided) share = half.guided->weight_of_others(child.direction, half.density(child.direction));
    child.sample_weight = half.weight * share;
    Interaction seen(child);
    trace(seen);
    radiance = seen.radiance * child.coefficient;
    if (half.guided) radiance *= static_cast<float>(share);
    return true;
}

// Draws a direction again that is below the true surface; after many tries it is turned back.
void Tracer::turn_upwards(const Hemisphere& half, Vec3& direction) {
    for (int draws = 0; dot(direction, half.surface_normal) < 0; ++draws) {
        if (draws == most_redraws) {
            direction -= half.surface_normal * (2.0 * dot(direction, half.surface_normal));
            return;
        }
        AimedRays again;
        again.across[0][0] = random_.uniform();
        again.across[1][0] = random_.uniform();
        again.aim(1, half.u, half.v, half.axis);
        direction = again[0];
    }
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
    half.lay_frame();
    if (guide_) half.guided.emplace(*this, at, half.kind, at.weight);
    const int cell_count = half.divisions * half.divisions;
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
    double weights = 0;
    if (observer_ && half.tilt) observer_->begin_sum();
    AimedRays rays;
    for (int cell = 0; cell < cell_count; cell += AimedRays::most) {
        const int count = std::min(cell_count - cell, AimedRays::most);
        aim_at_cells(half, cell, count, at, rays);
        for (int i = 0; i < count; ++i) {
            if (!trace_ambient(half, rays, i, at, radiance)) continue;
            sum.add_scaled(radiance, static_cast<float>(half.weight));
            weights += half.weight;
            ++traced;
        }
    }
    const double balance = half.balance(traced, weights);
    if (observer_ && half.tilt) observer_->end_sum(balance);
    if (balance != 1) sum *= static_cast<float>(balance);
    return traced > 0;
}

// Rays of a hemisphere that go where it is bright.
void Tracer::guide_hemisphere(const Hemisphere& half, const Spectrum& coefficient, Interaction& at,
                              Spectrum& sum) {
    Spectrum radiance(at.channels());
    for (int i = 0; i < half.guided->count(); ++i) {
        const Vec3 wi = half.guided->draw(i);
        const double density = half.density(wi);
        if (!(density > 0)) continue;
        const double share = half.share_of(wi) / half.guided->total(wi, density);
        const Spectrum size = coefficient * static_cast<float>(std::fabs(share));
        const double sign = share < 0 ? -1 : 1;
        if (trace_guided(half.kind, size, wi, at, radiance, sign))
            sum.add_scaled(radiance, static_cast<float>(sign));
    }
}

// A ray through a random place of each of `count` cells in a row.
void Tracer::aim_at_cells(const Hemisphere& half, int first, int count, const Interaction& at,
                          AimedRays& rays) {
    const int n = half.divisions;
    const double size = 1.0 / n;
    int row = first / n, column = first % n;
    for (int i = 0; i < count; ++i) {
        spread_scattering(at, half.kind, first + i);
        rays.across[0][i] = (row + random_.uniform()) * size;
        rays.across[1][i] = (column + random_.uniform()) * size;
        if (++column == n) {
            column = 0;
            ++row;
        }
    }
    rays.aim(count, half.u, half.v, half.axis);
}

// Ray number `again`, from 0, through a random place of a cell.
bool Tracer::sample_cell(Hemisphere& half, int cell, int again, Interaction& at, Spectrum& radiance) {
    const int n = half.divisions;
    spread_scattering(at, half.kind, again * n * n + cell);
    AimedRays rays;
    rays.across[0][0] = (cell / n + random_.uniform()) / n;
    rays.across[1][0] = (cell % n + random_.uniform()) / n;
    rays.aim(1, half.u, half.v, half.axis);
    return trace_ambient(half, rays, 0, at, radiance);
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
        if (!sample_cell(half, c, 0, at, cell.mean)) continue;
        cell.brightness = cell.mean.brightness();
        cell.mean *= static_cast<float>(half.weight);
        cell.weight = static_cast<float>(half.weight);
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
                if (!sample_cell(half, c, k, at, radiance)) break;
                const float share = 1.0f / static_cast<float>(k + 1);
                cell.mean *= static_cast<float>(k) * share;
                cell.mean.add_scaled(radiance, static_cast<float>(half.weight) * share);
                cell.weight += (static_cast<float>(half.weight) - cell.weight) * share;
            }
        }
    }
    double weights = 0;
    for (const HemisphereCell& cell : cells) {
        sum += cell.mean;
        weights += static_cast<double>(cell.weight);
    }
    const double balance = half.balance(traced, weights);
    if (balance != 1) sum *= static_cast<float>(balance);
    scratch_->hemispheres[level] = std::move(cells);
    return traced > 0;
}

}  // namespace infra
