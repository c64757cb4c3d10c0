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

    /// The sides that a point lies beyond: of the lower faces by axis, then of the upper ones; 0 inside.
    unsigned outcode(const Vec3& p) const {
        unsigned code = 0;
        for (int i = 0; i < 3; ++i) {
            code |= unsigned(p[i] < low[i] - tiny_length) << i;
            code |= unsigned(p[i] > high[i] + tiny_length) << (3 + i);
        }
        return code;
    }

    /// Does any part of the way from a to b lie inside?
    bool holds_part_of(const Vec3& a, const Vec3& b) const {
        return holds_part_of(a, outcode(a), b, outcode(b));
    }
    /// The same where the outcodes are known. Cuts off what lies beyond one face after another.
    /// source: Cohen and Sutherland's algorithm, Newman & Sproull, "Principles of Interactive Computer
    /// Graphics" (1979).
    bool holds_part_of(Vec3 a, unsigned code_a, Vec3 b, unsigned code_b) const {
        for (int cuts = 0; code_a | code_b; ++cuts) {
            constexpr int most_cuts = 6;
            if (code_a & code_b || cuts == most_cuts) return false;
            if (code_a == 0) {
                std::swap(a, b);
                std::swap(code_a, code_b);
            }
            if (code_a & (1 | 1 << 3))
                cut<0>(a, b, code_a);
            else if (code_a & (2 | 2 << 3))
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
        const double plane = code_a >> axis & 1 ? low[axis] : high[axis];
        const double part = (plane - a[axis]) / (b[axis] - a[axis]);
        a += (b - a) * part;
        a[axis] = plane;
    }
};

}  // namespace infra
