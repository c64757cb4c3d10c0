// Analytic BRDFs that coatings are fitted with. Angles in radians, parameters without a unit.
#pragma once

#include "nrlbrdf/models.h"

namespace infra {

/// Sandford and Robertson's model of infrared paints. Its incident directional-hemispherical reflectance is
/// 1 - emissivity g(theta_i)/G exactly; it is not reciprocal, and its lobe grows as 1/cos(theta_r).
struct SandfordRobertson {
    double emissivity = 0.5;  ///< hemispherical, 0..1
    double diffuse = 0.3;     ///< hemispherical diffuse reflectance, 0..1 - emissivity
    double grazing = 0.2;     ///< b, how fast emission and diffuse reflection fall towards grazing, 0 < b < 1
    double width = 0.2;       ///< e, width of the lobe, 0 < e < 1

    /// 1/(1 + b^2 tan^2 theta).
    double falloff(double theta) const;
    /// G: 2 times the integral of falloff cos sin over theta, which makes the two hemispherical.
    double falloff_mean() const;
    /// H: the lobe's integral over the hemisphere, so that the lobe reflects what is left.
    double lobe_integral(double theta_i) const;
};

/// source: Sandford and Robertson, "Infrared Reflectance Properties of Aircraft Paints", Proc. IRIS Targets,
/// Backgrounds and Discrimination (1985).
BrdfFunction sandford_robertson(const SandfordRobertson& parameters);

/// Maxwell and Beard's model as the Nonconventional Exploitation Factors database has it: a first-surface
/// lobe with shadowing and obscuration, a Lambertian and a volume part. Reciprocal. The lobe has no bound at
/// grazing angles and nothing keeps the sum below 1: measured parameters do, away from grazing.
struct BeardMaxwell {
    double n = 1.5, k = 0;  ///< index n + ik of the coating
    double bias = 0.1;      ///< B, strength of the lobe, >= 0
    double sigma = 0.2;     ///< width of the slopes' distribution, > 0
    double diffuse = 0.2;   ///< pi rho_D, reflectance of the Lambertian part, 0..1
    double volume = 0;      ///< rho_V [1/sr], >= 0
    double tau = 0.3;       ///< shadowing falls off over this bistatic angle [rad], > 0
    double omega = 1;       ///< and rises over this half-vector angle [rad], > 0
};

/// source: Maxwell, Beard, Weiner, Ladd and Ladd, "Bidirectional Reflectance Model Validation and
/// Utilization", AFAL-TR-73-303 (1973); Westlund and Meyer, "A BRDF Database Employing the Beard-Maxwell
/// Reflection Model", Graphics Interface 2002, eq. 1-5.
BrdfFunction beard_maxwell(const BeardMaxwell& parameters);

/// Lambertian plus GGX facets with height-correlated shadowing and Fresnel reflection. Reciprocal; without
/// bound only where both directions graze.
///   alpha   roughness, > 0
///   n, k    index n + ik of the facets
///   source  Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 33;
///           Heitz, JCGT 3 (2014), eq. 99
BrdfFunction ggx(double diffuse, double alpha, double n, double k);

}  // namespace infra
