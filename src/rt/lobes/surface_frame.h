// Directions along a surface, for lobes that are not the same all around its normal.
#pragma once

#include <cmath>

#include "common/vec.h"

namespace infra {

/// Three orthogonal unit vectors.
struct SurfaceFrame {
    Vec3 u, v;
    Vec3 normal;  ///< with its textures, facing the viewer

    Vec3 to_local(const Vec3& d) const { return {dot(d, u), dot(d, v), dot(d, normal)}; }
};

/// Any frame around a normal.
inline SurfaceFrame frame_around(const Vec3& normal) {
    SurfaceFrame frame{Vec3{0}, Vec3{0}, normal};
    make_frame(normal, frame.u, frame.v);
    return frame;
}

/// The frame around a normal whose u lies in the plane of the normal and `along`. False where there is no
/// such frame, for a vector that is zero, along the normal or not finite: `frame` is then any around the
/// normal.
inline bool frame_along(const Vec3& along, const Vec3& normal, SurfaceFrame& frame) {
    const Vec3 across = cross(normal, along);
    const double size = length(across);
    if (!(size > 0 && std::isfinite(size))) {
        frame = frame_around(normal);
        return false;
    }
    frame.v = across / size;
    frame.u = cross(frame.v, normal);
    frame.normal = normal;
    return true;
}

}  // namespace infra
