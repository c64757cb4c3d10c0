// Follows rays through a compiled scene: one Tracer per thread.
//
//     Tracer tracer(*scene, settings);
//     tracer.start_stream(pixel);  // random numbers of this ray and all that follow from it
//     Ray ray = tracer.primary(origin, direction, 0);
//     Interaction at(ray); tracer.trace(at);  // at.radiance, at.apparent_distance(), ...
//
// The path of a ray reads top to bottom in tracer.cpp: trace -> shade -> transport -> child rays.
#pragma once

#include <cstdint>
#include <memory>

#include "cal/evaluator.h"
#include "common/owen_sobol.h"
#include "common/random.h"
#include "rt/compile/compiled_scene.h"
#include "rt/ray.h"
#include "rt/ray_counts.h"
#include "rt/settings.h"

namespace infra {

class Guide;
struct AimedRays;
class IrradianceCache;
class PhotonMaps;
class Scattering;
class Split;
struct SourceAim;

/// Sees every ray once its radiance is known (rtrace -ot and -oT, rcontrib). The parents of `at` are alive
/// and can be followed.
class RayObserver {
  public:
    virtual ~RayObserver() = default;
    virtual void observe(const Interaction& at) = 0;

    /// Whether a ray that has arrived at this surface, a light source, need be observed: asked with
    /// ShadowRays::arriving alone.
    virtual bool watches(int) const { return true; }
    /// What is observed from the one call to the other is part of a sum that is multiplied in the end.
    virtual void begin_sum() {}
    virtual void end_sum(double /*factor*/) {}
};

/// Which of the rays towards light sources an observer sees.
enum class ShadowRays {
    stopped,   ///< those that meet something else on their way
    all,       ///< also those that nothing blocks
    arriving,  ///< those that bring light, and what it passes on its way: blocked ones cost no more than ever
};

class Tracer {
  public:
    Tracer(const CompiledScene& scene, const RenderSettings& settings, std::uint64_t seed = 0);
    ~Tracer();

    /// Begins the random stream of a primary ray.
    void start_stream(std::uint64_t index) {
        random_.begin(seed_, index);
        spreads_ = false;
    }
    /// The same for ray `number` of several whose mean is wanted. What is drawn for them up to the first
    /// scattering, they included, is spread over them by sequences of low discrepancy that `sequence` names.
    void start_stream(std::uint64_t index, std::uint64_t sequence, std::uint32_t number) {
        start_stream(index);
        spreads_ = true;
        sequence_ = seed_of(seed_, sequence);
        number_ = number;
    }
    /// Takes the next two random numbers from the sequence of this place in the path of a ray, if there is
    /// one.
    ///   place  what they are drawn for; another for everything that is drawn for one ray
    void spread(std::uint64_t place) {
        if (spreads_) random_.choose(owen_sobol_point(number_, seed_of(sequence_, place)));
    }
    RandomStream& random() { return random_; }

    /// Interpolates diffuse interreflection among values of this cache, and adds new ones; nullptr, as at the
    /// start: every hemisphere is computed. Threads may share it; it must outlive the tracer.
    void use_irradiance_cache(IrradianceCache* cache) { irradiance_cache_ = cache; }

    /// direction must have unit length; max_distance 0: no limit.
    Ray primary(const Vec3& origin, const Vec3& direction, double max_distance) const;

    /// Radiance along at.ray: finds what it meets, and shades it.
    void trace(Interaction& at);
    /// Radiance of what stands at infinity along the ray, whatever is in the way.
    void view_sky(Interaction& at);
    /// Only finds what the ray meets.
    void cast(Interaction& at);
    /// Irradiance [W m^-2] of a surface at the ray's origin that faces back along the ray (rtrace -I).
    void irradiance(Interaction& at);

    /// Rays traced so far: primary, secondary and shadow rays.
    std::uint64_t ray_count() const { return rays_.total(); }
    const RayCounts& rays() const { return rays_; }
    void set_observer(RayObserver* observer, ShadowRays shadows = ShadowRays::stopped) {
        observer_ = observer;
        observed_shadows_ = shadows;
    }
    /// Radiances that were not finite, replaced by 0 when they were met.
    std::uint64_t bad_values() const { return bad_values_; }
    /// Temperatures of thermal surfaces that their patterns made 0 K or less: they emit nothing.
    std::uint64_t bad_temperatures() const { return bad_temperatures_; }
    void count_bad_temperature() { ++bad_temperatures_; }

    // For modifiers
    // ------------------------------------------------------------------------------------------------

    const CompiledScene& scene() const { return scene_; }
    const RenderSettings& settings() const { return settings_; }

    /// Runs a chain of modifiers up to its material. False if there is none.
    bool shade_chain(const Modifier* chain, Interaction& at);
    /// Runs the patterns of a chain. A material among them is an error that compilation has excluded.
    void apply_patterns(const Modifier* chain, Interaction& at);
    /// Continues the ray behind `at` as if nothing were there.
    void pass_through(Interaction& at);
    /// The same into another medium: nullptr for none. Ends where the ray has become too light.
    void pass_into(const Medium* beyond, Interaction& at);
    /// Turns what a material scatters into rays and adds their radiance. at.normal faces the viewer.
    void transport(const Scattering& scattering, Interaction& at);
    /// Meets one surface alone, whatever stands before it. False if the ray misses it.
    bool meet(int surface, Interaction& at) const;
    /// Value of a function expression for this hit; see rt/functions/functions.h.
    cal::Evaluator& evaluator() { return evaluator_; }
    bool is_flat(const Interaction& at) const;
    /// Whether a photon map has what specular materials do with light on its way to the diffuse surface that
    /// a ray has come from.
    bool is_in_photon_map(const Ray& ray) const;

  private:
    struct Contribution;
    struct Scratch;

    bool spawn(Ray& child, std::uint16_t kind, const Interaction& from, const Spectrum* coefficient);
    /// Deeper recursion would endanger the thread's stack.
    bool stack_is_used_up() const;
    bool intersect(Interaction& at);
    bool meet_distant_source(Interaction& at) const;
    bool view_source(Interaction& at);
    void complete_hit(const HitState& state, Interaction& at) const;
    void shade(Interaction& at);

    void trace_in_vacuum(Interaction& at);
    void trace_in_air(Interaction& at);
    void add_thermal_emission(const Scattering& scattering, Interaction& at);
    void trace_mirror(const Scattering& scattering, Interaction& at);
    void trace_through(const Scattering& scattering, Interaction& at);
    /// Spreads the direction of a ray that is about to be scattered, if it is the first one of its path.
    void spread_scattering(const Interaction& at, std::uint16_t kind, int sample) {
        if (spreads_) [[unlikely]]
            spread_first_scattering(at, kind, sample);
    }
    void spread_first_scattering(const Interaction& at, std::uint16_t kind, int sample);
    int lobe_ray_count(const class Lobe& lobe, const Interaction& at) const;
    void trace_lobe(const class Lobe& lobe, Interaction& at);
    void guide_lobe(const class Lobe& lobe, int count, const class GuidedShare& guided, Interaction& at);

    // guiding/guided_rays.cpp
    friend class GuidedShare;
    /// One ray of this coefficient towards what is bright, unless it is too light and unlucky.
    ///   returns  false if it was not traced; else radiance holds what it adds
    ///   sign     with which the caller counts it, 1 or -1
    bool trace_guided(std::uint16_t kind, const Spectrum& coefficient, const Vec3& direction,
                      const Interaction& at, Spectrum& radiance, double sign = 1);

    // ambient/cached_ambient.cpp
    friend class HemisphereGatherer;  // ambient/hemisphere_gatherer.h
    const Spectrum& assumed_ambient(Spectrum& average) const;
    bool add_cached_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side,
                            Interaction& at);

    // photons/photon_light.cpp
    bool continuation_is_in_photon_map(const Ray& ray, bool straight_on) const;
    bool add_photons(const Spectrum& coefficient, bool other_side, Interaction& at);
    void add_direct_photons(const Scattering& scattering, Interaction& at);

    // volume/participation.cpp
    void participate(Interaction& at);
    void add_scattered(int source, Interaction& at);
    void add_scattered_photons(const PhotonMaps& maps, Interaction& at);
    bool light_at_place(int source, double distance, const Spectrum& share, const Interaction& at,
                        Spectrum& result);

    // ambient/hemisphere.cpp
    struct Hemisphere;
    void add_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side, Interaction& at);
    bool sample_hemisphere(Hemisphere& half, Interaction& at, Spectrum& sum);
    bool sample_adaptively(Hemisphere& half, int extra, Interaction& at, Spectrum& sum);
    void aim_at_cells(const Hemisphere& half, int first, int count, const Interaction& at, AimedRays& rays);
    bool sample_cell(Hemisphere& half, int cell, int again, Interaction& at, Spectrum& radiance);
    void turn_upwards(const Hemisphere& half, Vec3& direction);
    bool spawn_ambient(Hemisphere& half, const Interaction& at);
    void guide_hemisphere(const Hemisphere& half, const Spectrum& coefficient, Interaction& at,
                          Spectrum& sum);
    bool trace_ambient(Hemisphere& half, const AimedRays& rays, int aimed, Interaction& at,
                       Spectrum& radiance);

    // sources/direct.cpp
    void add_direct(const Scattering& scattering, Interaction& at);
    void consider_source(int source, const Scattering& scattering, const Interaction& at);
    void add_sample(int source, const SourceAim& aim, const Scattering& scattering, const Interaction& at);
    bool even_source_value(Contribution& contribution, const Interaction& at);
    bool source_value(Contribution& contribution, const Interaction& at);
    bool test_shadow(Contribution& contribution, const Interaction& at);
    void show_arrival(const Ray& ray);

    const CompiledScene& scene_;
    const RenderSettings& settings_;
    std::uint64_t seed_;
    RandomStream random_;
    bool spreads_ = false;  // what is drawn is spread over the rays of a pixel:
    std::uint64_t sequence_ = 0;
    std::uint32_t number_ = 0;
    cal::Evaluator evaluator_;
    IrradianceCache* irradiance_cache_ = nullptr;
    const Guide* guide_;  // where rays are sent besides, nullptr: nowhere
    const Split* split_;  // of radiance into components, nullptr: there is one
    RayObserver* observer_ = nullptr;
    ShadowRays observed_shadows_ = ShadowRays::stopped;
    const char* stack_base_ = nullptr;  // where the primary ray under way was started
    RayCounts rays_;
    std::uint64_t bad_values_ = 0;
    std::uint64_t bad_temperatures_ = 0;

    std::unique_ptr<Scratch> scratch_;  // arrays that keep their memory from ray to ray
};

}  // namespace infra
