// A ray and the place where it ends.
//
// Directions have unit length, distances are in scene units. A Ray is what goes out; an Interaction is what
// it meets and the radiance that comes back. Both live on the stack of the worker that traces them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "common/spectra/spectrum.h"
#include "common/vec.h"
#include "rt/volume/medium.h"

namespace infra {

/// Nearer than this is "the same place" (RADIANCE's figure): hits below it are the ray's own surface.
inline constexpr double same_place = 1e-6;
/// Distance of what is not there, as rtrace prints it.
inline constexpr double infinite_distance = 1e10;

/// How a ray came about; a ray's lineage is the union of its kind and those of all rays before it.
enum RayKind : std::uint16_t {
    primary_ray = 1,
    reflected_shadow = 2,
    mirrored_ray = 4,
    through_ray = 8,  ///< straight on, or transmitted without scatter
    reflected_ambient = 16,
    reflected_lobe = 32,
    through_shadow = 64,
    through_ambient = 128,
    through_lobe = 256,

    shadow_rays = reflected_shadow | through_shadow,
    ambient_rays = reflected_ambient | through_ambient,
    lobe_rays = reflected_lobe | through_lobe,
    /// Kinds that count as a reflection towards -lr and turn back into the room they came from.
    turning_rays = reflected_shadow | mirrored_ray | reflected_ambient | reflected_lobe,
};

inline constexpr std::uint32_t no_flat_shape = ~0u;

struct Cut;
struct Interaction;

/// A shape of the scene, and in which instance: numbers as in geometry/geometry.h, 0 for none.
struct PlacedShape {
    std::uint32_t shape = no_flat_shape;
    std::uint64_t placement = 0;
};

struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, 1};
    double max_distance = 0;   ///< nothing beyond is seen; 0: no limit
    double fore = 0;           ///< distance from the camera to where the primary ray starts
    double path_before = 0;    ///< length of the path from the eye to the origin
    double shadow_before = 0;  ///< length of the shadow rays before this one
    const Interaction* parent = nullptr;
    PlacedShape leaving;             ///< flat shape that the ray starts on and so cannot meet
    double weight = 1;               ///< share of the primary ray's value that this one can still change
    Spectrum coefficient;            ///< of this ray's radiance in its parent's
    double sample_weight = 1;        ///< a further factor on that: of a sample that is not like all others
    const Spectrum* tint = nullptr;  ///< and one a channel, nullptr: 1
    bool starts_within = false;      ///< before its parent's end: the coefficient knows that medium's part
    const Medium* medium = nullptr;  ///< what it starts in, nullptr: nothing
    const Cut* cut = nullptr;     ///< what antimatter takes out of its way (volume/cut.h), nullptr: nothing
    int level = 0;                ///< reflections so far
    int ambient_level = 0;        ///< diffuse bounces so far
    int aimed_source = -1;        ///< the light source that a shadow ray goes to
    bool past_obstacles = false;  ///< meets only that source, and the mirrors that it is the image of
    std::uint16_t kind = primary_ray;
    std::uint16_t lineage = primary_ray;

    explicit Ray(int channels) : coefficient(channels, 1.0f) {}
    bool is(std::uint16_t kinds) const { return (lineage & kinds) != 0; }
};

/// What of a view is a distant source seen straight on, or through something clear.
struct SkyView {
    Spectrum radiance;
    Spectrum share;  ///< its coefficient in the view

    explicit SkyView(int channels) : radiance(channels), share(channels) {}
};

struct Interaction {
    const Ray* ray;
    double weight;     ///< the ray's, less within mixtures and behind a medium
    double share = 1;  ///< of this part in the mixture that it belongs to

    // Where: set by the intersection, the point is the ray's origin where nothing near was hit
    double distance = infinite_distance;
    Vec3 point;
    Vec3 normal;        ///< of the surface, turned to the ray once a material has seen its back
    double cosine = 1;  ///< of ray and normal, negative from behind
    std::uint32_t flat_shape = no_flat_shape;  ///< the shape if it is flat
    int surface = -1;                          ///< index among the scene's surfaces, -1: nothing
    std::uint64_t placement = 0;               ///< number of the instance it is met in (Geometry), 0: none
    double local_uv[2] = {0, 0};               ///< of a mesh: the functions' Lu and Lv
    Vec3 perturbation{0};                      ///< of the normal, the sum of the textures met so far
    bool flipped = false;
    bool counted_elsewhere = false;  ///< a light source whose light reaches the ray's start by other rays
    /// What the ray meets behind a surface that is nothing to it (Tracer::pass_through), -1: it has stopped
    /// here.
    int surface_behind = -1;

    /// What the ray has travelled in: what it started in, unless the boundary at its end knows better.
    const Medium* medium;
    const Cut* cut_beyond;  ///< as the ray's, for rays that go on through the surface

    // What: set while shading
    /// Planck's radiance at the temperature of the surface being shaded, if it has one
    /// (materials/thermal.cpp): its material emits what it neither reflects nor transmits of it.
    const Spectrum* blackbody = nullptr;
    /// Where to say how much of the radiance comes straight from the sky; nullptr if nobody asks.
    SkyView* sky = nullptr;
    Spectrum pattern;   ///< product of the patterns met so far
    Spectrum radiance;  ///< towards the ray's origin
    Spectrum mirrored;  ///< the part of it that is a mirror image
    double mirrored_distance = infinite_distance;
    double direct_distance = infinite_distance;  ///< optical length of the rest
    std::optional<Medium> found_medium;          ///< what `medium` points to once it has been corrected

    explicit Interaction(const Ray& r)
        : ray(&r),
          weight(r.weight),
          point(r.origin),
          normal(-r.direction),
          medium(r.medium),
          cut_beyond(r.cut),
          pattern(r.coefficient.channels(), 1.0f),
          radiance(r.coefficient.channels()),
          mirrored(r.coefficient.channels()) {}

    bool textured() const { return dot(perturbation, perturbation) > same_place * same_place; }
    /// The normal with its textures, unit length, on the same side of the ray as the true one.
    Vec3 perturbed_normal() const {
        if (!textured()) return normal;
        const Vec3 sum = normal + perturbation;
        const double size = length(sum);
        if (!(size > 0)) return normal;
        const Vec3 turned = sum / size;
        const double c = -dot(turned, ray->direction);
        return (c > 0) == (cosine > 0) ? turned : turned + ray->direction * (2.0 * c);
    }

    /// Corrects `medium` from the ray's end.
    void has_travelled_in(const Medium& found) { medium = &found_medium.emplace(found); }

    bool hit() const { return surface >= 0; }
    int channels() const { return radiance.channels(); }

    /// Distance to what is mainly seen: through mirrors when those dominate.
    double apparent_distance() const {
        return mirrored.brightness() > 0.5f * radiance.brightness() ? mirrored_distance : direct_distance;
    }

    void flip() {
        normal = -normal;
        perturbation = -perturbation;
        cosine = -cosine;
        flipped = !flipped;
    }
};

}  // namespace infra
