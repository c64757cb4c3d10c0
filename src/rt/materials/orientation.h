// Which way a surface is rougher: the first four string arguments of plastic2, metal2, trans2 and ashik2.
#pragma once

#include "rt/functions/functions.h"
#include "rt/lobes/surface_frame.h"

namespace infra {

/// A vector from a function file, `ux uy uz funcfile transform...`, that is laid along the surface.
class Orientation {
  public:
    /// throws  Error as FunctionSet does
    explicit Orientation(ModifierContext& context) : vector_(context, 0, 3, 3) {}

    /// The frame around a normal whose u lies in the plane of the normal and the vector. False where there is
    /// no such frame, for a vector that is zero, along the normal or has a domain error: `frame` is then any
    /// around the normal, and the material should be the same all around.
    bool frame(Tracer& tracer, const Interaction& at, const Vec3& normal, SurfaceFrame& frame) const;

  private:
    FunctionSet vector_;
};

}  // namespace infra
