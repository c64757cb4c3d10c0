// Random shapes of every kind, as text.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "traced_scene.h"

namespace infra::test {

struct Dice {
    RandomStream random{11, 1};
    double between(double a, double b) { return a + (b - a) * random.uniform(); }
    Vec3 point(double reach) {
        return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
    }
    Vec3 direction() { return test::direction(std::acos(between(-1, 1)), between(0, 2 * std::numbers::pi)); }
};

inline std::string text_of(const Vec3& v) { return words(v.x, v.y, v.z); }

/// A star-shaped polygon of `count` corners, concave for many.
inline std::string random_polygon(Dice& dice, const Vec3& center, int count) {
    Vec3 u, v;
    make_frame(dice.direction(), u, v);
    std::string text = words("m polygon p 0 0", 3 * count);
    for (int n = 0; n < count; ++n) {
        const double angle = 2 * std::numbers::pi * (n + 0.8 * dice.random.uniform()) / count,
                     r = dice.between(0.1, 0.6);
        text += text_of(center + u * (r * std::cos(angle)) + v * (r * std::sin(angle)));
    }
    return text + "\n";
}

inline std::string random_shapes(Dice& dice, int count) {
    static const char* const cones[] = {"cone", "cup"};
    static const char* const cylinders[] = {"cylinder", "tube"};
    static const char* const spheres[] = {"sphere", "bubble"};
    std::string text = "void plastic m 0 0 5 .5 .5 .5 0 0\n";
    for (int n = 0; n < count; ++n) {
        const Vec3 center = dice.point(5);
        const int flip = static_cast<int>(2 * dice.random.uniform());
        switch (n % 6) {
            case 0:
                text += words("m", spheres[flip], "s 0 0 4", text_of(center), dice.between(0.02, 0.4), "\n");
                break;
            case 1:
                text += words("m", cylinders[flip], "c 0 0 7", text_of(center),
                              text_of(center + dice.point(0.7)), dice.between(0.02, 0.3), "\n");
                break;
            case 2:
                text += words("m", cones[flip], "c 0 0 8", text_of(center), text_of(center + dice.point(0.7)),
                              dice.between(0.0, 0.3), dice.between(0.01, 0.3), "\n");
                break;
            case 3:
                text += words("m ring r 0 0 8", text_of(center), text_of(dice.direction()),
                              dice.between(0, 0.2), dice.between(0.2, 0.5), "\n");
                break;
            case 4:
                text += random_polygon(dice, center, 3);
                break;
            default:
                text += random_polygon(dice, center, 4 + n % 5);
                break;
        }
    }
    return text;
}

}  // namespace infra::test
