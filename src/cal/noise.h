// The noise functions of RADIANCE, value for value.
#pragma once

namespace infra::cal {

/// Gradient noise, about -1 to 1, zero at integer points.
/// source: Perlin, "Improving Noise", SIGGRAPH 2002.
double gradient_noise(double x, double y, double z);

/// Derivative of gradient_noise along an axis (0 to 2), by a backward difference over 0.0005.
double gradient_noise_slope(int axis, double x, double y, double z);

/// Fractal noise, about -1 to 1: random values on a cube's corners, subdivided down to 0.0005.
double fractal_noise(double x, double y, double z);

/// The expression language's rand(x), in [0, 1).
double hash_random(double x);

}  // namespace infra::cal
