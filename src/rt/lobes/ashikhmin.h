// The specular lobe of ashik2: facets whose normals follow a power of the cosine, one power along the
// surface's u and another along its v.
//
// source: Ashikhmin and Shirley, "An Anisotropic Phong BRDF Model", JGT 5 (2000), as RADIANCE 6.1 evaluates
// it: the Fresnel reflection stands in the coefficient, for the viewer's angle and not the facet's.
#pragma once

#include <cmath>
#include <numbers>

#include "rt/lobes/lobe.h"
#include "rt/lobes/surface_frame.h"
#include "rt/lobes/ward.h"
#include "rt/ray.h"

namespace infra {

struct AshikhminSetting {
    Vec3 view_direction;      ///< of the ray, towards the surface
    SurfaceFrame frame;       ///< along which the powers are given
    Vec3 surface_normal;      ///< without textures: no ray goes below this one
    double power_u, power_v;  ///< >= 0
    double specular_samples;  ///< -ss
};

class AshikhminReflection final : public Lobe {
  public:
    AshikhminReflection(const Spectrum& coefficient_, const AshikhminSetting& setting)
        : Lobe(reflected_lobe, coefficient_),
          s_(setting),
          amplitude_(std::sqrt((s_.power_u + 1) * (s_.power_v + 1)) * (0.5 * std::numbers::inv_pi)) {
        redraws = true;
    }

    /// The size of the source changes nothing.
    double eval(const Vec3& wi, double) const override {
        const double cosine = dot(wi, s_.frame.normal);
        if (cosine <= same_place) return 0;
        const double cosine_out = std::max(-dot(s_.view_direction, s_.frame.normal), 0.001);
        const Vec3 half = normalize(wi - s_.view_direction);
        const double density = facet_density(half) / (4 * dot(wi, half) * std::max(cosine, cosine_out));
        return density > same_place ? density * cosine : 0;
    }

    /// As in RADIANCE 6.1 each sample weighs 1 and is drawn again when it falls below the surface: the lobe
    /// keeps all its energy, where eval() loses some towards grazing.
    LobeDraw sample(RandomStream& random, int, int) const override {
        const Vec3 half = draw_facet(random);
        const Vec3 wi = s_.view_direction + half * (-2.0 * dot(half, s_.view_direction));
        return {normalize(wi), dot(wi, s_.surface_normal) > same_place ? 1.0 : 0.0};
    }

    /// What falls below the surface is missing from its integral.
    double pdf(const Vec3& wi) const override {
        if (dot(wi, s_.surface_normal) <= same_place) return 0;
        const Vec3 half = normalize(wi - s_.view_direction);
        return facet_density(half) / (4 * dot(wi, half));
    }

    int sample_count(double ray_weight) const override {
        return ward_sample_count(s_.specular_samples, ray_weight);
    }

  private:
    /// Density of facets by the direction of their normals [1/sr].
    double facet_density(const Vec3& half) const {
        const Vec3 local = s_.frame.to_local(half);
        if (local.z <= 0) return 0;
        const double tangent2 = 1 - local.z * local.z;
        if (tangent2 <= 0) return amplitude_;
        const double power = (s_.power_u * local.x * local.x + s_.power_v * local.y * local.y) / tangent2;
        return amplitude_ * std::pow(local.z, power);
    }

    Vec3 draw_facet(RandomStream& random) const {
        const double turn = 2 * std::numbers::pi * random.uniform();
        double x = std::sqrt(s_.power_v + 1) * std::cos(turn), y = std::sqrt(s_.power_u + 1) * std::sin(turn);
        const double size = std::hypot(x, y);
        x /= size;
        y /= size;
        const double power = s_.power_u * x * x + s_.power_v * y * y;
        const double cosine = std::pow(random.uniform(), 1 / (power + 1));
        const double sine = std::sqrt(1 - cosine * cosine);
        return s_.frame.u * (x * sine) + s_.frame.v * (y * sine) + s_.frame.normal * cosine;
    }

    AshikhminSetting s_;
    double amplitude_;
};

}  // namespace infra
