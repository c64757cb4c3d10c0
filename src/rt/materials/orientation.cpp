#include "rt/materials/orientation.h"

namespace infra {

bool Orientation::frame(Tracer& tracer, const Interaction& at, const Vec3& normal,
                        SurfaceFrame& frame) const {
    double d[3];
    const bool defined = vector_.evaluate(tracer, at, d);
    // As in RADIANCE, an instance does not turn it.
    const Vec3 along = defined ? vector_.turned({d[0], d[1], d[2]}) : Vec3{0};
    return frame_along(along, normal, frame);
}

}  // namespace infra
