#include "rt/tracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "rt/guiding/guided_share.h"
#include "rt/materials/scattering.h"
#include "rt/scratch.h"
#include "rt/split/split.h"
#include "rt/volume/cut.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr double distant = infinite_distance * 0.99;
/// Stack that a primary ray and its descendants may use before a path is given up, in bytes: far more than
/// -lr and -lw leave to any sensible scene, and half of what a thread has.
constexpr std::ptrdiff_t stack_budget = 4 << 20;

}  // namespace

Tracer::Tracer(const CompiledScene& scene, const RenderSettings& settings, std::uint64_t seed)
    : scene_(scene),
      settings_(settings),
      seed_(seed),
      random_(seed, 0),
      evaluator_(scene.program()),
      guide_(settings.guided_samples > 0 ? scene.guide() : nullptr),
      split_(scene.split()),
      scratch_(std::make_unique<Scratch>()) {}

Tracer::~Tracer() = default;

Ray Tracer::primary(const Vec3& origin, const Vec3& direction, double max_distance) const {
    Ray ray(scene_.channel_count());
    ray.origin = origin;
    ray.direction = direction;
    ray.max_distance = max_distance;
    ray.medium = scene_.medium();
    return ray;
}

// The path of a ray
// -----------------------------------------------------------------------------------------------------

void Tracer::trace(Interaction& at) {
    if (!at.ray->parent) stack_base_ = static_cast<const char*>(__builtin_frame_address(0));
    if (at.ray->past_obstacles) [[unlikely]] {
        view_source(at);
        return;
    }
    if (scene_.air() && !settings_.irradiance && !(at.ray->lineage & ~(primary_ray | through_ray)))
        trace_in_air(at);
    else
        trace_in_vacuum(at);
    if (!at.radiance.finite()) {
        ++bad_values_;
        at.radiance.clear();
        at.mirrored.clear();
    }
    if (observer_) observer_->observe(at);  // before the medium takes its part, as in RADIANCE
    if (at.medium) [[unlikely]]
        participate(at);
    if (split_ && !(at.ray->kind & (primary_ray | through_ray))) [[unlikely]]
        split_->arrive(at.surface_behind >= 0 ? at.surface_behind : at.surface, at.radiance);
}

void Tracer::trace_in_vacuum(Interaction& at) {
    if (intersect(at)) {
        shade(at);
        return;
    }
    if (at.ray->max_distance > tiny) return;  // ended by the aft clipping plane
    view_sky(at);
    if (at.sky) {
        at.sky->radiance = at.radiance;
        at.sky->share.fill(1.0f);
    }
}

void Tracer::view_sky(Interaction& at) {
    if (meet_distant_source(at)) shade_chain(scene_.finish(at.surface).modifier, at);
}

// Along a camera ray. Distant sources, as the sky, are given as the camera sees them: the air dims the rest,
// and adds its own light in front of the rest.
void Tracer::trace_in_air(Interaction& at) {
    SkyView own(at.channels());
    SkyView* const asked = at.sky;
    if (!asked) at.sky = &own;
    trace_in_vacuum(at);
    const SkyView& sky = *at.sky;
    if (at.distance < distant) {
        Spectrum air(at.channels()), transmittance(at.channels());
        const double start = at.ray->fore + at.ray->path_before;
        const double near = at.ray->parent ? start : 0.0;  // the camera stands before the clipping plane
        scene_.air()->stretch(near, start + at.distance, transmittance, air);
        if (split_) air = split_->on_path(air);
        for (int c = 0; c < at.channels(); ++c)
            at.radiance.set(c, transmittance[c] * (at.radiance[c] - sky.radiance[c]) +
                                   air[c] * (1.0f - sky.share[c]) + sky.radiance[c]);
        at.mirrored *= transmittance;
    }
    at.sky = asked;
}

void Tracer::cast(Interaction& at) {
    if (!intersect(at) && at.ray->max_distance <= tiny) meet_distant_source(at);
}

void Tracer::irradiance(Interaction& at) {
    stack_base_ = static_cast<const char*>(__builtin_frame_address(0));
    constexpr double above = 1e-5;  // where the imagined surface lies, as in RADIANCE
    at.distance = at.direct_distance = above;
    at.point = at.ray->origin + at.ray->direction * above;
    at.normal = -at.ray->direction;
    at.cosine = 1;
    scene_.irradiance_material().shade(*this, at);
}

bool Tracer::intersect(Interaction& at) {
    rays_.count(at.ray->kind);
    HitState state;
    if (at.ray->max_distance > tiny) state.distance = at.ray->max_distance;
    scene_.geometry().intersect(at.ray->origin, at.ray->direction, at.ray->leaving, state);
    if (state.surface < 0) {
        if (at.ray->max_distance > tiny) at.point = at.ray->origin + at.ray->direction * at.ray->max_distance;
        return false;
    }
    complete_hit(state, at);
    if (at.medium) [[unlikely]]
        at.weight *= at.medium->weight_left(at.distance);
    return true;
}

bool Tracer::meet(int surface, Interaction& at) const {
    HitState state;
    const Geometry& geometry = scene_.geometry();
    if (!geometry.intersect_one(geometry.shape_of(surface), at.ray->origin, at.ray->direction, state))
        return false;
    complete_hit(state, at);
    return true;
}

void Tracer::complete_hit(const HitState& state, Interaction& at) const {
    at.distance = state.distance;
    at.surface = state.surface;
    at.point = at.ray->origin + at.ray->direction * state.distance;
    scene_.geometry().describe(state, at);
    at.cosine = -dot(at.ray->direction, at.normal);
}

bool Tracer::meet_distant_source(Interaction& at) const {
    const Ray& ray = *at.ray;
    const auto covers = [&](const LightSource& source) {
        return dot(source.center, ray.direction) >= source.least_cosine;
    };
    if (ray.aimed_source >= 0) {
        const LightSource& aimed = scene_.source(ray.aimed_source);
        if (!aimed.distant() || aimed.is_virtual() || !covers(aimed)) return false;
        at.surface = aimed.surface;
        return true;
    }
    // Small bright sources win over wide glows; an illum that nothing stands behind is the last choice but
    // one.
    int glow = -1;
    bool see_through = false;
    for (const int i : scene_.distant_sources()) {
        const LightSource& source = scene_.source(i);
        if (!covers(source)) continue;
        if (source.skip) {
            if (glow < 0) glow = source.surface;
        } else if (source.passes_unseen) {
            see_through = true;
        } else {
            at.surface = source.surface;
            return true;
        }
    }
    if (see_through && ray.is(ambient_rays | lobe_rays)) return false;
    at.surface = glow;
    return glow >= 0;
}

void Tracer::shade(Interaction& at) {
    const Finish& finish = scene_.finish(at.surface);
    const bool removed = at.ray->cut && at.ray->cut->removes(finish.primitive);
    if (removed || !shade_chain(finish.modifier, at)) pass_through(at);
}

bool Tracer::shade_chain(const Modifier* chain, Interaction& at) {
    if (stack_is_used_up()) return true;  // materials within materials, thousands deep
    at.direct_distance = at.distance;
    const bool irradiance_here = settings_.irradiance && !(at.ray->lineage & ~(primary_ray | through_ray));
    for (; chain; chain = chain->next()) {
        const MaterialTraits* material = irradiance_here ? chain->traits() : nullptr;
        if (material && !material->is_light && !material->is_mixture) {
            if (material->transparent || material->stands_for_others) {
                pass_through(at);
            } else {
                at.pattern.fill(1.0f);
                scene_.irradiance_material().shade(*this, at);
            }
            return true;
        }
        if (chain->shade(*this, at)) return true;
    }
    return false;
}

void Tracer::apply_patterns(const Modifier* chain, Interaction& at) {
    for (; chain; chain = chain->next()) chain->shade(*this, at);
}

void Tracer::pass_through(Interaction& at) {
    Ray child(at.channels());
    spawn(child, through_ray, at, nullptr);  // goes on whatever its weight
    if (at.distance >= distant || stack_is_used_up()) return;
    child.direction = at.ray->direction;
    Interaction beyond(child);
    SkyView sky(at.sky ? at.channels() : 1);
    if (at.sky) beyond.sky = &sky;
    trace(beyond);
    if (at.sky) *at.sky = sky;
    at.radiance = beyond.radiance;
    at.mirrored = beyond.mirrored;
    at.mirrored_distance = at.distance + beyond.mirrored_distance;
    at.direct_distance = at.distance + beyond.direct_distance;
    at.surface_behind = beyond.surface_behind >= 0 ? beyond.surface_behind : beyond.surface;
}

void Tracer::pass_into(const Medium* beyond, Interaction& at) {
    Scattering clear(at.normal, at.channels());
    clear.through_coefficient.fill(1.0f);
    clear.through_direction = at.ray->direction;
    clear.as_clear_as_air = true;
    clear.changes_medium = true;
    clear.medium_beyond = beyond;
    trace_through(clear, at);
}

bool Tracer::stack_is_used_up() const {
    return stack_base_ - static_cast<const char*>(__builtin_frame_address(0)) > stack_budget;
}

bool Tracer::is_flat(const Interaction& at) const {
    if (at.flat_shape == Geometry::no_shape) return false;
    return !at.placement || !scene_.geometry().is_covered(at.placement);
}

// From what a material scatters to child rays
// -----------------------------------------------------------------------------

void Tracer::transport(const Scattering& scattering, Interaction& at) {
    if (scattering.has_through) trace_through(scattering, at);
    if (at.ray->is(shadow_rays)) {
        if (scattering.has_mirror && scattering.relayed_source >= 0) trace_mirror(scattering, at);
        return;
    }
    if (at.blackbody) add_thermal_emission(scattering, at);
    if (scattering.has_mirror) trace_mirror(scattering, at);
    if (scattering.pure_specular) return;
    for (int i = 0; i < scattering.lobe_count; ++i)
        if (scattering.lobe_sampled[i]) trace_lobe(*scattering.lobes[i], at);
    add_ambient(scattering.ambient, scattering.normal, false, at);
    add_ambient(scattering.ambient_through, -scattering.through_normal, true, at);
    add_direct(scattering, at);
}

// Kirchhoff: what is neither reflected nor transmitted is emitted.
void Tracer::add_thermal_emission(const Scattering& scattering, Interaction& at) {
    Spectrum albedo(at.channels());
    scattering.smooth_albedo(albedo);
    for (int i = 0; i < scattering.lobe_count && !scattering.pure_specular; ++i) {
        const Lobe& lobe = *scattering.lobes[i];
        if (scattering.lobe_sampled[i])
            albedo.add_scaled(lobe.coefficient,
                              static_cast<float>(lobe.mean_weight(lobe_ray_count(lobe, at))));
    }
    for (int c = 0; c < at.channels(); ++c)
        at.radiance.set(c, at.radiance[c] + std::max(0.0f, 1.0f - albedo[c]) * (*at.blackbody)[c]);
}

void Tracer::trace_through(const Scattering& scattering, Interaction& at) {
    Ray child(at.channels());
    if (scattering.is_refracted() && !at.ray->is(shadow_rays) &&
        continuation_is_in_photon_map(*at.ray, false))
        return;
    if (!spawn(child, through_ray, at, &scattering.through_coefficient)) return;
    if (scattering.relayed_source >= 0) child.aimed_source = scattering.relayed_source;
    child.direction = scattering.through_direction;
    if (scattering.changes_medium) child.medium = scattering.medium_beyond;
    Interaction beyond(child);
    SkyView sky(at.sky ? at.channels() : 1);
    if (at.sky) beyond.sky = &sky;
    trace(beyond);
    if (at.sky) {
        at.sky->radiance.add_product(sky.radiance, child.coefficient);
        at.sky->share.add_product(sky.share, child.coefficient);
    }
    at.radiance.add_product(beyond.radiance, child.coefficient);
    if (scattering.as_clear_as_air) {
        at.mirrored = beyond.mirrored * child.coefficient;
        at.mirrored_distance = at.distance + beyond.mirrored_distance;
        at.direct_distance = at.distance + beyond.direct_distance;
    } else if (scattering.seen_through) {
        at.direct_distance = at.distance + beyond.apparent_distance();
    }
}

void Tracer::trace_mirror(const Scattering& scattering, Interaction& at) {
    Ray child(at.channels());
    if (!spawn(child, mirrored_ray, at, &scattering.mirror_coefficient)) return;
    child.aimed_source = scattering.relayed_source;
    child.direction = normalize(scattering.mirror_direction);
    Interaction image(child);
    trace(image);
    at.mirrored = image.radiance * child.coefficient;
    at.radiance += at.mirrored;
    at.mirrored_distance = at.distance;
    if (scattering.image_behind) at.mirrored_distance += image.apparent_distance();
}

void Tracer::spread_first_scattering(const Interaction& at, std::uint16_t kind, int sample) {
    if (at.ray->is(ambient_rays | lobe_rays)) return;
    const auto place = static_cast<std::uint64_t>(at.ray->lineage) << 16 | kind;
    spread(
        seed_of(place, static_cast<std::uint64_t>(at.ray->level) << 32 | static_cast<std::uint32_t>(sample)));
}

// Number of rays for a lobe: as many as -lw leaves each of them heavy enough.
int Tracer::lobe_ray_count(const Lobe& lobe, const Interaction& at) const {
    const int wanted = lobe.sample_count(at.weight);
    const double weight = at.weight * std::fmin(lobe.coefficient.maximum(), 1.0);
    if (settings_.min_weight <= 0 || weight > settings_.min_weight * wanted) return wanted;
    return std::max(1, static_cast<int>(std::min<double>(weight / settings_.min_weight, most_samples)));
}

void Tracer::trace_lobe(const Lobe& lobe, Interaction& at) {
    Ray child(at.channels());
    const int count = lobe_ray_count(lobe, at);
    std::optional<GuidedShare> guided;
    if (guide_ && lobe.exact(count)) guided.emplace(*this, at, lobe.kind, at.weight);
    if (!spawn(child, lobe.kind, at, &lobe.coefficient)) {
        const bool by_chance = settings_.max_reflections <= 0;
        if (guided && by_chance) guide_lobe(lobe, count, *guided, at);
        return;
    }
    if (count > 1) {
        child.coefficient *= 1.0f / static_cast<float>(count);
        child.weight /= count;
    }
    Spectrum sum(at.channels()), tint(at.channels(), 1.0f);
    const int most_draws = lobe.redraws ? count * Lobe::most_redraws : count;
    const bool by_draws = lobe.redraws && lobe.counts_draws && count > 1;
    if (observer_ && by_draws) observer_->begin_sum();
    int draws = 0, traced = 0;
    for (; traced < count && draws < most_draws; ++draws) {
        spread_scattering(at, lobe.kind, draws);
        const LobeDraw draw = lobe.sample(random_, draws, count);
        random_.choose_no_more();
        if (draw.lost != 0 && at.blackbody) {  // not reflected, so absorbed
            if (lobe.colored) lobe.tint(draw.wi, tint);
            sum.add_scaled(*at.blackbody * child.coefficient * tint, static_cast<float>(draw.lost));
        }
        if (draw.weight <= 0) continue;
        ++traced;
        child.direction = draw.wi;
        child.sample_weight = draw.weight;
        if (guided) child.sample_weight *= guided->weight_of_others(draw.wi, count * lobe.pdf(draw.wi));
        if (lobe.colored) [[unlikely]] {
            lobe.tint(draw.wi, tint);
            child.tint = &tint;
        }
        Interaction seen(child);
        trace(seen);
        seen.radiance *= child.coefficient;
        if (lobe.colored) [[unlikely]]
            seen.radiance *= tint;
        sum.add_scaled(seen.radiance, static_cast<float>(child.sample_weight));
    }
    const float per_draw = static_cast<float>(count) / static_cast<float>(draws);
    if (observer_ && by_draws) observer_->end_sum(double(per_draw));
    if (by_draws)
        sum *= per_draw;
    else if (lobe.redraws && at.blackbody)
        sum.add_scaled(*at.blackbody * child.coefficient, static_cast<float>(count - traced));
    at.radiance += sum;
    if (guided) guide_lobe(lobe, count, *guided, at);
}

// Rays of a lobe that go where it is bright.
void Tracer::guide_lobe(const Lobe& lobe, int count, const GuidedShare& guided, Interaction& at) {
    Spectrum radiance(at.channels()), tint(at.channels());
    for (int i = 0; i < guided.count(); ++i) {
        const Vec3 wi = guided.draw(i);
        const double value = lobe.eval(wi, 0);
        if (!(value > 0)) continue;
        Spectrum coefficient =
            lobe.coefficient * static_cast<float>(value / guided.total(wi, count * lobe.pdf(wi)));
        if (lobe.colored) {
            lobe.tint(wi, tint);
            coefficient *= tint;
        }
        if (trace_guided(lobe.kind, coefficient, wi, at, radiance)) at.radiance += radiance;
    }
}

bool Tracer::spawn(Ray& child, std::uint16_t kind, const Interaction& from, const Spectrum* coefficient) {
    if (from.distance >= distant) return false;
    const Ray& parent = *from.ray;
    double share = 1.0;
    if (coefficient) {
        child.coefficient = *coefficient;
        share = std::fmin(coefficient->maximum(), 1.0);  // weights never grow
    }
    child.parent = &from;
    child.leaving = {from.flat_shape, from.placement};
    child.origin = from.point;
    child.kind = kind;
    child.lineage = parent.lineage | kind;
    child.level = parent.level;
    child.ambient_level = parent.ambient_level;
    child.aimed_source = parent.aimed_source;
    child.past_obstacles = parent.past_obstacles;
    child.fore = parent.fore;
    child.path_before = parent.path_before + from.distance;
    child.shadow_before = parent.is(shadow_rays) ? parent.shadow_before + from.distance : 0.0;
    child.medium = from.medium;
    child.cut = kind & turning_rays ? parent.cut : from.cut_beyond;
    if (kind & turning_rays) {
        ++child.level;
        child.aimed_source = -1;
        child.max_distance = 0;
    } else {
        child.max_distance = parent.max_distance > tiny ? parent.max_distance - from.distance : 0.0;
        if (parent.max_distance > tiny && child.max_distance <= tiny) return false;  // ends at the aft plane
    }
    child.weight = from.weight * share;
    if (child.weight <= 0 || stack_is_used_up()) return false;
    if (child.lineage & shadow_rays) return true;
    if (continuation_is_in_photon_map(parent, kind == through_ray)) return false;

    if (settings_.max_reflections <= 0 && coefficient) {  // Russian roulette
        if (settings_.max_reflections < 0 && child.level > -settings_.max_reflections) return false;
        if (child.weight >= settings_.min_weight) return true;
        if (random_.uniform() > child.weight / settings_.min_weight) return false;
        child.coefficient *= static_cast<float>(settings_.min_weight / child.weight);
        child.weight = settings_.min_weight;
        return true;
    }
    return child.weight >= settings_.min_weight && child.level <= std::abs(settings_.max_reflections);
}

}  // namespace infra
