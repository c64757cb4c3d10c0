// What a material does to light at one hit: the answer of SurfaceMaterial::scatter, which the tracer turns
// into rays.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "common/spectra/spectrum.h"
#include "common/vec.h"
#include "rt/lobes/lobe.h"
#include "rt/lobes/source_response.h"

namespace infra {

struct Medium;

/// What makes the approximation end at 0; that of all smooth materials but WGMDfunc.
inline constexpr double default_fresnel_offset = 0.00287989916;

/// RADIANCE's approximation of Fresnel reflection, for a smooth surface at cosine c.
double fresnel_approximation(double c, double offset = default_fresnel_offset);

/// Schlick's approximation: of what a surface does not reflect straight on, the share that it reflects at
/// cosine c.
double schlick_share(double c);

class Scattering {
  public:
    Scattering(const Vec3& shading_normal, int channels)
        : normal(shading_normal),
          through_normal(shading_normal),
          fresnel_normal(shading_normal),
          mirror_coefficient(channels),
          through_coefficient(channels),
          diffuse(channels),
          diffuse_through(channels),
          ambient(channels),
          ambient_through(channels) {}
    Scattering(const Scattering&) = delete;
    Scattering& operator=(const Scattering&) = delete;

    Vec3 normal;          ///< with its textures, facing the viewer
    Vec3 through_normal;  ///< the same for diffuse transmission, where it has textures of its own
    Vec3 fresnel_normal;  ///< and of the smooth surface that fresnel_coupled speaks of

    // Perfect specular rays
    bool has_mirror = false;
    bool has_through = false;
    Spectrum mirror_coefficient;
    Vec3 mirror_direction{0};
    Spectrum through_coefficient;
    Vec3 through_direction{0};
    int relayed_source =
        -1;  ///< what a shadow ray is aimed at beyond a mirror or prism, -1: what it was before
    bool as_clear_as_air = false;  ///< what lies behind is all that is seen, mirror images included
    bool seen_through = false;     ///< the apparent distance is that of what lies behind
    bool changes_medium = false;   ///< the through ray travels on in:
    const Medium* medium_beyond = nullptr;
    /// Factor by which refraction changes radiance without any energy lost or gained: it is part of
    /// through_coefficient and squeezes or widens the solid angle.
    float radiance_change = 1;

    // Lambertian parts, as reflectance
    Spectrum diffuse;
    Spectrum diffuse_through;
    bool fresnel_coupled = false;  ///< the diffuse parts lose what the smooth surface reflects
    double fresnel_offset = default_fresnel_offset;  ///< of fresnel_approximation()
    bool schlick_coupled = false;  ///< the same by Schlick's formula: all passes straight on
    // The same for the indirect calculation: with the lobes that are too weak to be sampled
    Spectrum ambient;
    Spectrum ambient_through;

    // Rough lobes: at most one each way. All answer for light sources, only the sampled ones send out rays.
    const Lobe* lobes[2] = {nullptr, nullptr};
    bool lobe_sampled[2] = {false, false};
    int lobe_count = 0;

    /// What answers for light sources only, nullptr: nothing.
    const SourceResponse* response = nullptr;

    /// True when nothing but mirror and through rays is left.
    bool pure_specular = false;
    bool image_behind = false;  ///< a mirror image is seen at its own distance, not at the surface's

    template <class L, class... Args>
    void add_lobe(bool sampled, Args&&... args) {
        static_assert(sizeof(L) <= slot_size && std::is_trivially_destructible_v<L>);
        lobes[lobe_count] = new (slots_[lobe_count]) L(std::forward<Args>(args)...);
        lobe_sampled[lobe_count] = sampled;
        ++lobe_count;
    }

    /// Takes the place of the first lobe.
    template <class R, class... Args>
    void set_response(Args&&... args) {
        static_assert(sizeof(R) <= slot_size && std::is_trivially_destructible_v<R>);
        response = new (slots_[0]) R(std::forward<Args>(args)...);
    }

    /// Whether the through ray passes the surface of a body, not a thin pane.
    bool is_refracted() const { return changes_medium && !as_clear_as_air; }

    /// Reflectance plus transmittance towards the viewer of all but the lobes that rays sample.
    void smooth_albedo(Spectrum& result) const;

    /// Reflected radiance per incident radiance and solid angle, f |cos| [1/sr], for a source of size omega
    /// [sr] around wi: Lambertian parts and, where they are wanted, lobes; not the mirror.
    void eval(const Vec3& wi, double omega, bool with_lobes, Spectrum& result) const;

  private:
    static constexpr std::size_t slot_size = 704;
    alignas(16) std::byte slots_[2][slot_size];
};

}  // namespace infra
