// The surfaces of a scene, 12 bytes each, and what all surfaces of one modifier have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "rt/modifier.h"
#include "scene/scene.h"

namespace infra {

/// A modifier as surfaces wear it.
struct Finish {
    PrimitiveId primitive = void_primitive;  ///< the modifier; the later one wins where two surfaces coincide
    const Modifier* modifier = nullptr;      ///< first of its chain, nullptr: void
    const MaterialTraits* material = nullptr;  ///< nullptr: a surface that rays pass
    bool in_ambient = true;                    ///< takes part in the diffuse indirect calculation (-ai, -ae)
    bool may_be_cut = false;                   ///< antimatter makes its surfaces vanish for some rays

    bool is_light() const { return material && material->is_light; }
    bool transparent() const { return material && material->transparent; }
    bool blocks_light() const { return material && material->blocks_light && !may_be_cut; }
};

struct Surface {
    PrimitiveId primitive = void_primitive;
    std::int32_t finish = 0;
    std::int32_t source = -1;  ///< light source number, -1: none
};

class SurfaceTable {
  public:
    std::vector<Surface> surfaces;
    std::vector<Finish> finishes;

    const Surface& operator[](int i) const { return surfaces[static_cast<std::size_t>(i)]; }
    const Finish& finish(int surface) const {
        return finishes[static_cast<std::size_t>((*this)[surface].finish)];
    }

    /// True if surface a beats surface b, both met in the same place: material over none, opaque over
    /// transparent, front over back, later modifier over earlier, and of one modifier the earlier surface
    /// (measured behaviour of RADIANCE 6.1, which keeps what it finds first in the last case).
    bool outranks(int a, bool a_front, int b, bool b_front) const {
        const Finish &fa = finish(a), &fb = finish(b);
        if ((fa.material != nullptr) != (fb.material != nullptr)) return fa.material != nullptr;
        if (fa.transparent() != fb.transparent()) return fb.transparent();
        if (a_front != b_front) return a_front;
        if (fa.primitive != fb.primitive) return fa.primitive > fb.primitive;
        return a < b;
    }
};

}  // namespace infra
