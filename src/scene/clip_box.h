// An axis-parallel box and what of a line lies in it, to RADIANCE's tolerance.
#pragma once

#include <utility>

#include "common/vec.h"

namespace infra {

/// Distances below this are none, scene units (RADIANCE's).
inline constexpr double tiny_length = 1e-6;

/// Box from `low` to `high`; what lies less than tiny_length beyond a face still counts as inside.
struct ClipBox {
    Vec3 low, high;

    /// Which side of which face a point lies on, 2 bits an axis; 0 inside.
    unsigned outcode(const Vec3& p) const {
        unsigned code = 0;
        for (int i = 0; i < 3; ++i) {
            code |= unsigned(p[i] < low[i] - tiny_length) << 2 * i;
            code |= unsigned(p[i] > high[i] + tiny_length) << (2 * i + 1);
        }
        return code;
    }

    /// Does any part of the way from a to b lie inside? Cuts off what lies beyond one face after another.
    /// source: Cohen and Sutherland's algorithm, Newman & Sproull, "Principles of Interactive Computer
    /// Graphics" (1979).
    bool holds_part_of(Vec3 a, Vec3 b) const {
        unsigned code_a = outcode(a), code_b = outcode(b);
        for (int cuts = 0; code_a | code_b; ++cuts) {
            constexpr int most_cuts = 6;
            if (code_a & code_b || cuts == most_cuts) return false;
            if (code_a == 0) {
                std::swap(a, b);
                std::swap(code_a, code_b);
            }
            if (code_a & 3)
                cut<0>(a, b, code_a);
            else if (code_a & 3 << 2)
                cut<1>(a, b, code_a);
            else
                cut<2>(a, b, code_a);
            code_a = outcode(a);
        }
        return true;
    }

    /// Moves a towards b onto the face of this axis that it lies beyond.
    template <int axis>
    void cut(Vec3& a, const Vec3& b, unsigned code_a) const {
        const double plane = code_a >> 2 * axis & 1 ? low[axis] : high[axis];
        const double part = (plane - a[axis]) / (b[axis] - a[axis]);
        a += (b - a) * part;
        a[axis] = plane;
    }
};

}  // namespace infra
