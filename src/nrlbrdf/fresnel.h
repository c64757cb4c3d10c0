// Reflection by a smooth boundary of a medium of complex refractive index.
#pragma once

namespace infra {

/// Unpolarised Fresnel reflectance from vacuum or air.
///   cos_theta  cosine of the angle between ray and boundary normal, 0..1
///   n, k       real part and extinction coefficient of the index n + ik; n > 0, k >= 0
///   returns    0..1; the emissivity of an opaque medium is 1 minus this
///   source     Born & Wolf, Principles of Optics, 7th ed., sec. 14.2
///   accuracy   VALIDATION V9, water at 4, 10 and 12 um: 1e-5
double fresnel_reflectance(double cos_theta, double n, double k);

}  // namespace infra
