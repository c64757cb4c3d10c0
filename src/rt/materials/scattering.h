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

namespace infra {

/// RADIANCE's approximation of Fresnel reflection, for a smooth surface at cosine c.
double fresnel_approximation(double c);

class Scattering {
  public:
    Scattering(const Vec3& shading_normal, int channels)
        : normal(shading_normal),
          mirror_coefficient(channels),
          through_coefficient(channels),
          diffuse(channels),
          diffuse_through(channels),
          ambient(channels),
          ambient_through(channels) {}
    Scattering(const Scattering&) = delete;
    Scattering& operator=(const Scattering&) = delete;

    Vec3 normal;  ///< with its textures, facing the viewer

    // Perfect specular rays
    bool has_mirror = false;
    bool has_through = false;
    Spectrum mirror_coefficient;
    Vec3 mirror_direction{0};
    Spectrum through_coefficient;
    Vec3 through_direction{0};
    bool as_clear_as_air = false;  ///< what lies behind is all that is seen, mirror images included
    bool seen_through = false;     ///< the apparent distance is that of what lies behind

    // Lambertian parts, as reflectance
    Spectrum diffuse;
    Spectrum diffuse_through;
    bool fresnel_coupled = false;  ///< the diffuse part loses what the smooth surface reflects
    // The same for the indirect calculation: with the lobes that are too weak to be sampled
    Spectrum ambient;
    Spectrum ambient_through;

    // Rough lobes: at most one each way. All answer for light sources, only the sampled ones send out rays.
    const Lobe* lobes[2] = {nullptr, nullptr};
    bool lobe_sampled[2] = {false, false};
    int lobe_count = 0;

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

    /// Reflectance plus transmittance towards the viewer of all but the lobes that rays sample.
    void smooth_albedo(Spectrum& result) const;

    /// Reflected radiance per incident radiance and solid angle, f |cos| [1/sr], for a source of size omega
    /// [sr] around wi: Lambertian parts and lobes, not the mirror.
    void eval(const Vec3& wi, double omega, Spectrum& result) const;

  private:
    static constexpr std::size_t slot_size = 384;
    alignas(16) std::byte slots_[2][slot_size];
};

}  // namespace infra
