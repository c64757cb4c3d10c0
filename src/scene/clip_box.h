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
            if (p[i] < low[i] - tiny_length)
                code |= 1u << 2 * i;
            else if (p[i] > high[i] + tiny_length)
                code |= 2u << 2 * i;
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
            int i = 0;
            while ((code_a >> 2 * i & 3) == 0) ++i;
            const double plane = code_a >> 2 * i & 1 ? low[i] : high[i];
            const double part = (plane - a[i]) / (b[i] - a[i]);
            const Vec3 way = b - a;
            for (int j = 0; j < 3; ++j) a[j] = j == i ? plane : a[j] + way[j] * part;
            code_a = outcode(a);
        }
        return true;
    }
};

}  // namespace infra
