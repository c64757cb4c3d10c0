#include "cal/noise.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace infra::cal {
namespace {

constexpr double step = .0005;  // of the differences and of the finest fractal cell: RADIANCE's figure

// Perlin's permutation of 0..255, eighteen entries a line.
constexpr std::array<std::uint8_t, 256> permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,   //
    103, 30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,   //
    0,   26,  197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149,  //
    56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166,  //
    77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,   //
    245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187,  //
    208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186,  //
    3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212,  //
    207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213, 119, 248,  //
    152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,  //
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,   //
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107,  //
    49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,    //
    150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,   //
    215, 61,  156, 180};

int hash(int i) { return permutation[static_cast<unsigned>(i) & 255u]; }

/// The cell that contains x. Below zero it is one lower at whole numbers, which changes nothing: noise is 0
/// there.
int cell_of(double x) {
    constexpr double limit = 1e9;  // keeps the conversion to int defined
    if (!(std::abs(x) < limit)) return 0;
    return static_cast<int>(x) - (x < 0);
}

double ease(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
double blend(double t, double a, double b) { return a + t * (b - a); }

/// Dot product of (x, y, z) with one of the twelve edge directions of a cube (four occur twice).
double slope(int corner, double x, double y, double z) {
    const int choice = corner & 15;
    const double first = choice < 8 ? x : y;
    double second = z;
    if (choice < 4) second = y;
    if (choice == 12 || choice == 14) second = x;
    return ((choice & 1) ? -first : first) + ((choice & 2) ? -second : second);
}

/// Random value in [-1, 1] of a lattice point. Unsigned, so that the products may wrap.
double lattice_random(std::int64_t x, std::int64_t y, std::int64_t z) {
    auto seed = static_cast<std::uint64_t>(17 * x + 23 * y + 29 * z);
    seed = (seed << 13) ^ seed;
    const std::uint64_t bits = (seed * (seed * seed * 15731 + 789221) + 1376312589) & 0x7fffffff;
    return 1 - static_cast<double>(bits) / 1073741824.;
}

using Lattice = std::array<std::int64_t, 3>;

double lattice_random(const Lattice& at) { return lattice_random(at[0], at[1], at[2]); }

}  // namespace

double gradient_noise(double x, double y, double z) {
    const int i = cell_of(x), j = cell_of(y), k = cell_of(z);
    x -= i;
    y -= j;
    z -= k;
    const double u = ease(x), v = ease(y), w = ease(z);
    double along_z[2];
    for (int dz = 0; dz < 2; ++dz) {
        double along_y[2];
        for (int dy = 0; dy < 2; ++dy) {
            double along_x[2];
            for (int dx = 0; dx < 2; ++dx) {
                const int corner = hash(hash(hash((i & 255) + dx) + (j & 255) + dy) + (k & 255) + dz);
                along_x[dx] = slope(corner, x - dx, y - dy, z - dz);
            }
            along_y[dy] = blend(u, along_x[0], along_x[1]);
        }
        along_z[dz] = blend(v, along_y[0], along_y[1]);
    }
    return blend(w, along_z[0], along_z[1]);
}

double gradient_noise_slope(int axis, double x, double y, double z) {
    const double here = gradient_noise(x, y, z);
    const double before =
        gradient_noise(axis == 0 ? x - step : x, axis == 1 ? y - step : y, axis == 2 ? z - step : z);
    return (here - before) / step;
}

// Each round halves the cube that contains the point. The new corners are means of old ones (the centre of
// eight, face centres of four, edge centres of two) plus a random displacement in proportion to the size.
double fractal_noise(double x, double y, double z) {
    constexpr double limit = 1e12;  // beyond, lattice coordinates would not fit 64 bits
    const std::array<double, 3> point{x, y, z};
    std::int64_t size = static_cast<std::int64_t>(1 / step);
    Lattice target, origin;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(point[axis]) < limit)) return 0;
        target[axis] = static_cast<std::int64_t>(static_cast<double>(size) * point[axis]);
        origin[axis] = static_cast<std::int64_t>(static_cast<double>(size) * std::floor(point[axis]));
    }
    std::array<double, 8> corner;
    for (int c = 0; c < 8; ++c) {
        Lattice at = origin;
        for (int axis = 0; axis < 3; ++axis)
            if (c >> axis & 1) at[axis] += size;
        corner[c] = lattice_random(at);
    }
    for (;;) {
        double mean = 0;
        for (const double value : corner) mean += value;
        mean *= .125;
        size >>= 1;
        if (size == 0) return mean;
        Lattice centre;
        int half = 0;  // which of the eight smaller cubes contains the point, one bit an axis
        for (int axis = 0; axis < 3; ++axis) {
            centre[axis] = origin[axis] + size;
            if (target[axis] > centre[axis]) half |= 1 << axis;
        }
        const auto displaced = [&](double value, const Lattice& at) {
            return value + static_cast<double>(size) * step * lattice_random(at);
        };
        const auto towards_point = [&](int axis) { return half >> axis & 1 ? size : -size; };
        corner[~half & 7] = displaced(mean, centre);
        for (int axis = 0; axis < 3; ++axis) {  // the three faces that bound the smaller cube
            double sum = 0;
            for (int c = 0; c < 8; ++c)
                if (~(c ^ half) & 1 << axis) sum += corner[c];
            Lattice at = centre;
            at[axis] += towards_point(axis);
            corner[~(half ^ 1 << axis) & 7] = displaced(.25 * sum, at);
        }
        for (int axis = 0; axis < 3; ++axis) {  // and its three edges, each along one axis
            const double sum = corner[half & ~(1 << axis)] + corner[half | 1 << axis];
            Lattice at = centre;
            for (int other = 0; other < 3; ++other)
                if (other != axis) at[other] += towards_point(other);
            corner[half ^ 1 << axis] = displaced(.5 * sum, at);
        }
        for (int axis = 0; axis < 3; ++axis)
            if (half >> axis & 1) origin[axis] += size;
    }
}

double hash_random(double x) {
    x *= 1 / (1 + x * x) + 2.71828182845904;
    x += .785398163397447 - std::floor(x);
    x = 1e5 / x;
    return x - std::floor(x);
}

}  // namespace infra::cal
