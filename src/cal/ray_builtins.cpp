// The functions that expressions of a scene have besides: real arguments, error functions, noise, and those
// that turn a luminaire's measured intensities into radiance.
#include <cmath>
#include <numbers>
#include <string>

#include "cal/builtin.h"
#include "cal/noise.h"
#include "cal/ray_library.h"

namespace infra::cal {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

Error constant_misuse(const Host& host, const char* function) {
    return host.error(std::string(function) + "() used in a constant expression",
                      "define it with '=', not ':'");
}

/// arg(n): the nth real argument of the primitive, arg(0): how many it has.
double real_argument(const double* a, const Host& host) {
    if (!host.channel && host.owner.empty() && host.reals.empty()) throw constant_misuse(host, "arg");
    const double rounded = a[0] + .5;
    if (!(rounded >= 1)) return static_cast<double>(host.reals.size());
    if (!(rounded < static_cast<double>(host.reals.size()) + 1)) {
        const std::string number =
            rounded < 1e9 ? std::to_string(static_cast<long>(rounded)) : "of that number";
        throw host.error("missing real argument " + number,
                         "arg(n) was asked for it, there are " + std::to_string(host.reals.size()));
    }
    return host.reals[static_cast<std::size_t>(rounded) - 1];
}

/// The real arguments 2, 3, 4 of a luminaire are its dimensions.
double dimension(const Host& host, std::size_t number) {
    if (host.reals.size() < number)
        throw host.error("source_corr() needs the luminaire's dimensions as real arguments");
    return host.reals[number - 1];
}

/// Area of a box of the luminaire's dimensions, as seen along (x, y, z).
double seen_area(const Host& host, double x, double y, double z) {
    const double dx = dimension(host, 2), dy = dimension(host, 3), dz = dimension(host, 4);
    return x * dy * dz + y * dx * dz + z * dx * dy;
}

/// source_corr(v, shape): v times the first real argument, over the area that the luminaire shows towards the
/// ray. shape: 0 none, 1 flat, 2 box, 3 box seen from nearby, 4 upright cylinder.
double source_correction(const double* a, const Host& host) {
    if (!host.channel) throw constant_misuse(host, "source_corr");
    double value = a[0];
    if (host.reals.size() > 1) value *= host.reals[0];
    if (value <= 0) return 0;
    const auto direction = [&](int axis) { return host.channel_value(ray_direction + axis); };
    switch (static_cast<int>(a[1] + .5)) {
        case 0:
            return value;
        case 1:
            return value / host.channel_value(ray_dot);
        case 2:
            return value /
                   seen_area(host, std::abs(direction(0)), std::abs(direction(1)), std::abs(direction(2)));
        case 3: {
            const double distance = host.channel_value(shadow_distance);
            const auto outside =
                [&](int axis) {  // how far the ray starts from the slab of the box along this axis
                    const double from =
                        host.channel_value(intersection_point + axis) - direction(axis) * distance;
                    return std::max(
                        0., std::abs(from) - .5 * dimension(host, static_cast<std::size_t>(axis) + 2));
                };
            return value * distance / seen_area(host, outside(0), outside(1), outside(2));
        }
        case 4: {
            constexpr double below_one = 1 - 1e-6;
            const double cosine = std::min(direction(2), below_one);
            const double diameter = dimension(host, 2), height = dimension(host, 3);
            const double side = diameter * height * std::sqrt(1 - cosine * cosine);
            return value / (side + .25 * std::numbers::pi * diameter * diameter * std::abs(cosine));
        }
        default:
            throw host.error("source_corr() has no such shape", "0 to 4 are known");
    }
}

/// source_theta(x): angle from the luminaire's downward axis in degrees, 0 to 180.
double source_theta(const double*, const Host& host) {
    if (!host.channel) throw constant_misuse(host, "source_theta");
    return degrees * std::acos(std::fmin(std::fmax(host.channel_value(ray_direction + 2), -1), 1));
}

/// source_phi(range): azimuth about that axis in degrees, folded into 0..range, which is 90, 180 or 360.
double source_phi(const double* a, const Host& host) {
    if (!host.channel) throw constant_misuse(host, "source_phi");
    double angle =
        degrees * std::atan2(-host.channel_value(ray_direction + 1), -host.channel_value(ray_direction));
    if (angle < 0) angle += 360;
    switch (static_cast<int>(a[0] + .5)) {
        case 90:
            if (angle >= 180) angle -= 180;
            return angle < 90 ? angle : 180 - angle;
        case 180:
            return angle < 180 ? angle : 360 - angle;
        case 360:
            return angle;
        default:
            throw host.error("source_phi() needs 90, 180 or 360");
    }
}

template <double (*function)(double)>
double call1(const double* a, const Host&) {
    return function(a[0]);
}

template <double (*function)(double, double, double)>
double call3(const double* a, const Host&) {
    return function(a[0], a[1], a[2]);
}

template <int axis>
double noise_slope(const double* a, const Host&) {
    return gradient_noise_slope(axis, a[0], a[1], a[2]);
}

constexpr Builtin ray[] = {
    {"arg", 1, false, real_argument},
    {"erf", 1, true, call1<std::erf>},
    {"erfc", 1, true, call1<std::erfc>},
    {"fnoise3", 3, true, call3<fractal_noise>},
    {"noise3", 3, true, call3<gradient_noise>},
    {"noise3x", 3, true, noise_slope<0>},
    {"noise3y", 3, true, noise_slope<1>},
    {"noise3z", 3, true, noise_slope<2>},
    {"source_corr", 2, false, source_correction},
    {"source_phi", 1, false, source_phi},
    {"source_theta", 1, false, source_theta},
};

}  // namespace

std::span<const Builtin> ray_builtins() { return ray; }

}  // namespace infra::cal
