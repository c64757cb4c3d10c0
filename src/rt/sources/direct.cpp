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

#include "rt/materials/scattering.h"
#include "rt/photons/photon_maps.h"
#include "rt/scratch.h"
#include "rt/sources/source_aim.h"
#include "rt/split/split.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;

}  // namespace

void Tracer::add_direct(const Scattering& scattering, Interaction& at) {
    if (scene_.photons() && scene_.photons()->direct()) {
        add_direct_photons(scattering, at);
        return;
    }
    if (scene_.sampled_sources().empty() || at.distance >= infinite_distance * 0.99) return;
    std::vector<Contribution>& all = scratch_->contributions;
    all.clear();
    for (const int source : scene_.sampled_sources()) consider_source(source, scattering, at);
    if (all.empty()) return;

    // Brightest first; tail[i] is what i and all after it could add.
    const std::size_t count = all.size();
    std::vector<Ranked>& order = scratch_->order;
    std::vector<float>& tail = scratch_->tail;
    order.clear();
    for (std::size_t i = 0; i < count; ++i)
        order.emplace_back(all[i].brightness, static_cast<std::uint32_t>(i));
    sort_brightest_first(order, scratch_->spare_order);
    tail.resize(count);
    float sum = 0;
    for (std::size_t i = count; i-- > 0;) tail[i] = sum += all[order[i].place()].brightness;

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
        Contribution& contribution = all[order[i].place()];
        if (test_shadow(contribution, at)) at.radiance += contribution.value;
    }
    // Of what is left one in each group is tested, and speaks for all.
    double tested = 0, visible = 0;
    for (std::size_t i = first_untested; i < count; i += group) {
        Contribution& contribution = all[order[i].place()];
        tested += contribution.brightness;
        if (test_shadow(contribution, at)) visible += contribution.brightness;
    }
    const auto chance = static_cast<float>(tested > 0 ? visible / tested : 0.0);
    for (std::size_t i = first_untested; i < count; ++i)
        at.radiance.add_scaled(all[order[i].place()].value, chance);
}

void Tracer::consider_source(int number, const Scattering& scattering, const Interaction& at) {
    const LightSource& source = scene_.source(number);
    if (is_out_of_reach(source, at.point)) return;
    Parts parts;
    divide_source(source, at.point, at.weight, settings_.source_size_ratio, parts);
    for (int p = 0; p < parts.count; ++p) {
        const Part& part = parts.part[p];
        if (settings_.source_jitter > 0) spread_scattering(at, reflected_shadow, number * most_parts + p);
        const Vec3 place = place_on(source, part, parts.count == 1, settings_.source_jitter, random_);
        random_.choose_no_more();
        SourceAim aim;
        if (aim_at(source, at.point, place, part.half[0] * part.half[1], aim))
            add_sample(number, aim, scattering, at);
    }
}

void Tracer::add_sample(int number, const SourceAim& aim, const Scattering& scattering,
                        const Interaction& at) {
    Contribution contribution{
        number, aim.direction, infinite_distance, Spectrum(at.channels()), Spectrum(at.channels()), 0};
    scattering.eval(aim.direction, aim.omega, !is_in_photon_map(*at.ray), contribution.coefficient);
    contribution.coefficient *= static_cast<float>(aim.omega);
    if (contribution.coefficient.maximum() <= 0) return;
    const bool even = scene_.source(number).even_radiance && !at.medium;
    if (!(even ? even_source_value(contribution, at) : source_value(contribution, at))) return;
    scratch_->contributions.push_back(contribution);
}

// What the source shows towards the point if nothing stands in between. False for black.
bool Tracer::even_source_value(Contribution& contribution, const Interaction& at) {
    const LightSource& source = scene_.source(contribution.source);
    if (source.distant()) {
        if (dot(source.center, contribution.direction) < source.least_cosine) return false;
    } else {
        HitState state;
        const Geometry& geometry = scene_.geometry();
        if (!geometry.intersect_one(geometry.shape_of(source.surface), at.point, contribution.direction,
                                    state))
            return false;
        if (!state.front) return source_value(contribution, at);
        contribution.distance = state.distance;
    }
    contribution.value = *source.even_radiance;
    if (split_) split_->arrive(source.surface, contribution.value);
    contribution.value *= contribution.coefficient;
    contribution.brightness = contribution.value.brightness();
    return contribution.brightness > 0;
}

// The same by a ray, for sources of any kind.
bool Tracer::source_value(Contribution& contribution, const Interaction& at) {
    Ray ray(at.channels());
    if (!spawn(ray, reflected_shadow, at, nullptr)) return false;
    ray.direction = contribution.direction;
    ray.aimed_source = contribution.source;
    ray.past_obstacles = true;
    Interaction seen(ray);
    if (!view_source(seen)) return false;
    contribution.distance = seen.distance;
    if (split_) split_->arrive(scene_.shining_surface(contribution.source), seen.radiance);
    contribution.value = seen.radiance * contribution.coefficient;
    contribution.brightness = contribution.value.brightness();
    return contribution.brightness > 0;
}

// Shades the source that a ray is aimed at, or the mirror that it is seen in, whatever stands in the way.
bool Tracer::view_source(Interaction& at) {
    const LightSource& source = scene_.source(at.ray->aimed_source);
    const bool at_infinity = source.distant() && !source.is_virtual();
    if (at_infinity ? !meet_distant_source(at) : !meet(source.surface, at)) return false;
    shade_chain(source.modifier, at);
    if (at.medium) participate(at);
    return true;
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
    const bool ends_here = !source.is_virtual();
    if (!observer_ || observed_shadows_ == ShadowRays::arriving) {
        const Geometry::View view =
            scene_.geometry().view(ray.origin, ray.direction, contribution.distance, ray.leaving);
        if (view == Geometry::View::blocked || (view == Geometry::View::clear && ends_here)) {
            rays_.count(ray.kind);
            if (observer_ && view == Geometry::View::clear) show_arrival(ray);
            return view == Geometry::View::clear;
        }
    }
    Interaction met(ray);
    const bool hit = intersect(met);
    const bool arrived = hit && ends_here && met.surface == source.surface;
    const bool observe_arrival = observer_ && observed_shadows_ != ShadowRays::stopped;
    if (hit && (!arrived || observe_arrival)) {
        shade(met);
        if (observer_) observer_->observe(met);
        if (arrived) return true;
        if (met.radiance.mean() <= tiny) return false;
        if (met.medium) participate(met);
        if (split_) split_->arrive(scene_.shining_surface(contribution.source), met.radiance);
        contribution.value = met.radiance * contribution.coefficient;
        return true;
    }
    if (!hit && observe_arrival && source.distant() && meet_distant_source(met)) {
        shade_chain(source.modifier, met);
        observer_->observe(met);
    }
    return true;
}

// Observes the end of a ray that nothing blocks.
void Tracer::show_arrival(const Ray& ray) {
    const LightSource& source = scene_.source(ray.aimed_source);
    if (!observer_->watches(source.surface)) return;
    Interaction met(ray);
    if (source.distant() ? !meet_distant_source(met) : !meet(source.surface, met)) return;
    shade_chain(source.modifier, met);
    observer_->observe(met);
}

}  // namespace infra
