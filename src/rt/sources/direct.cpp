// Direct light: every sampled source is divided into parts, each part aimed at once; the brightest are tested
// for shadow, the rest estimated.
//
// source: Ward, "Adaptive Shadow Testing for Ray Tracing" (1991), for -dt and -dc; part sizes and sample
// places as measured from RADIANCE 6.1. The visibility of untested sources is estimated from a few of them at
// the same point, not from statistics over past rays, so that a picture does not depend on the order of its
// pixels.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "rt/materials/scattering.h"
#include "rt/scratch.h"
#include "rt/sources/source_parts.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double least_projection = 1e-4;  // of a part: smaller ones are edge-on

}  // namespace

void Tracer::add_direct(const Scattering& scattering, Interaction& at) {
    if (scene_.sampled_sources().empty() || at.distance >= infinite_distance * 0.99) return;
    std::vector<Contribution>& all = scratch_->contributions;
    all.clear();
    for (const int source : scene_.sampled_sources()) consider_source(source, scattering, at);
    if (all.empty()) return;

    // Brightest first; tail[i] is what i and all after it could add.
    const std::size_t count = all.size();
    std::vector<std::uint32_t>& order = scratch_->order;
    std::vector<float>& tail = scratch_->tail;
    order.resize(count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return all[a].brightness > all[b].brightness; });
    tail.resize(count);
    float sum = 0;
    for (std::size_t i = count; i-- > 0;) tail[i] = sum += all[order[i]].brightness;

    const auto group = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::pow(static_cast<double>(count), settings_.shadow_certainty) + 0.5));
    const double threshold = settings_.shadow_threshold / at.weight;
    constexpr std::size_t always_tested = 2;
    std::size_t first_untested = count;
    for (std::size_t i = 0; i < count; ++i) {
        const float at_stake = i + group >= count ? tail[i] : tail[i] - tail[i + group];
        if (i >= always_tested && at_stake < threshold * at.radiance.brightness()) {
            first_untested = i;
            break;
        }
        Contribution& contribution = all[order[i]];
        if (test_shadow(contribution, at)) at.radiance += contribution.value;
    }
    // Of what is left one in each group is tested, and speaks for all.
    double tested = 0, visible = 0;
    for (std::size_t i = first_untested; i < count; i += group) {
        Contribution& contribution = all[order[i]];
        tested += contribution.brightness;
        if (test_shadow(contribution, at)) visible += contribution.brightness;
    }
    const auto chance = static_cast<float>(tested > 0 ? visible / tested : 0.0);
    for (std::size_t i = first_untested; i < count; ++i) at.radiance.add_scaled(all[order[i]].value, chance);
}

void Tracer::consider_source(int number, const Scattering& scattering, const Interaction& at) {
    const LightSource& source = scene_.source(number);
    if (source.is_glow && source.extent != LightSource::Extent::distant) {
        const double reach = source.reach + source.radius;
        const Vec3 offset = at.point - source.center;
        if (dot(offset, offset) > reach * reach) return;
    }
    Parts parts;
    divide_source(source, at.point, at.weight, settings_.source_size_ratio, parts);
    const double jitter = settings_.source_jitter;
    for (int p = 0; p < parts.count; ++p) {
        const Part& part = parts.part[p];
        double offset[3] = {part.center[0], part.center[1], 0};
        if (jitter > tiny) {
            offset[0] += jitter * (1 - 2 * random_.uniform()) * part.half[0];
            offset[1] += jitter * (1 - 2 * random_.uniform()) * part.half[1];
            if (source.extent != LightSource::Extent::flat) offset[2] += jitter * (1 - 2 * random_.uniform());
        }
        if (source.round && (parts.count > 1 || jitter > 0.7)) round_off(source, jitter > tiny, offset);
        const Vec3 target = source.center + source.half_axis[0] * offset[0] +
                            source.half_axis[1] * offset[1] + source.half_axis[2] * offset[2];
        add_sample(number, scattering, at, target, part.half[0] * part.half[1]);
    }
}

// Aims at one place of a source; share: of the source that it stands for.
void Tracer::add_sample(int number, const Scattering& scattering, const Interaction& at, const Vec3& target,
                        double share) {
    const LightSource& source = scene_.source(number);
    const bool at_infinity = source.extent == LightSource::Extent::distant;
    const Vec3 offset = at_infinity ? target : target - at.point;
    const double distance = length(offset);
    if (!(distance > 0)) return;
    const Vec3 direction = offset / distance;

    double omega = share;
    if (at_infinity) {
        omega *= source.size;
    } else {
        if (source.extent == LightSource::Extent::flat) {
            omega *= -dot(source.normal, direction);
        } else if (source.extent == LightSource::Extent::cylinder) {
            const Vec3& axis = source.half_axis[0];
            const double along = dot(direction, axis);
            omega *= std::sqrt(std::max(0.0, 1.0 - along * along / dot(axis, axis)));
        }
        if (omega <= least_projection) return;
        if (source.is_glow && distance > source.reach) return;
        omega *= source.size / (distance * distance);
    }
    if (source.is_spot) {
        if (source.beam.misses(direction)) return;
        if (!at_infinity) {  // the beam spreads from its focus behind the source
            const double from_focus = distance + source.beam.focal_length;
            omega *= distance * distance / (from_focus * from_focus);
        }
    }
    Contribution contribution{
        number, direction, infinite_distance, Spectrum(at.channels()), Spectrum(at.channels()), 0};
    scattering.eval(direction, omega, contribution.coefficient);
    contribution.coefficient *= static_cast<float>(omega);
    if (contribution.coefficient.maximum() <= 0 || !source_value(contribution, at)) return;
    scratch_->contributions.push_back(contribution);
}

// What the source shows towards the point if nothing stands in between. False for black.
bool Tracer::source_value(Contribution& contribution, const Interaction& at) {
    const LightSource& source = scene_.source(contribution.source);
    Ray ray(at.channels());
    if (!spawn(ray, reflected_shadow, at, nullptr)) return false;
    ray.direction = contribution.direction;
    ray.aimed_source = contribution.source;
    Interaction seen(ray);
    if (source.extent == LightSource::Extent::distant) {
        if (!meet_distant_source(seen)) return false;
    } else {
        HitState state;
        if (!scene_.geometry().intersect_one(scene_.geometry().shape_of(source.surface), ray.origin,
                                             ray.direction, state))
            return false;
        complete_hit(state, seen);
        contribution.distance = state.distance;
    }
    shade_chain(source.modifier, seen);
    contribution.value = seen.radiance * contribution.coefficient;
    contribution.brightness = contribution.value.brightness();
    return contribution.brightness > 0;
}

// Whether any of the source's light arrives; filters on the way colour it.
bool Tracer::test_shadow(Contribution& contribution, const Interaction& at) {
    const LightSource& source = scene_.source(contribution.source);
    const bool through = (at.cosine > 0) != (dot(at.normal, contribution.direction) > 0);
    Ray ray(at.channels());
    spawn(ray, through ? through_shadow : reflected_shadow, at, nullptr);
    ray.direction = contribution.direction;
    ray.aimed_source = contribution.source;
    ray.coefficient = contribution.coefficient;
    if (!observer_) {
        const Geometry::View view =
            scene_.geometry().view(ray.origin, ray.direction, contribution.distance, ray.leaving);
        if (view != Geometry::View::filtered) {
            ++ray_count_;
            return view == Geometry::View::clear;
        }
    }
    Interaction met(ray);
    const bool hit = intersect(met);
    if (hit && (met.surface != source.surface || observe_shadows_)) {
        shade(met);
        if (observer_) observer_->observe(met);
        if (met.surface == source.surface) return true;
        if (met.radiance.mean() <= tiny) return false;
        contribution.value = met.radiance * contribution.coefficient;
        return true;
    }
    if (!hit && observe_shadows_ && source.extent == LightSource::Extent::distant &&
        meet_distant_source(met)) {
        shade_chain(source.modifier, met);
        observer_->observe(met);
    }
    return true;
}

}  // namespace infra
