// Rays from a mirror to a light source, sent out before the rendering to see whether any light arrives.
#pragma once

#include "rt/sources/light_relay.h"
#include "rt/tracer.h"

namespace infra {

class Pretest {
  public:
    /// The tracer's settings give the number of rays (-dp), its scene the sources.
    explicit Pretest(Tracer& tracer) : tracer_(tracer) {}

    /// Whether the surface sees a source, which may be virtual itself. True also where nothing is known:
    /// without rays, or for a surface that is hard to hit.
    bool sees(const RelaySurface& surface, int source);

  private:
    int ray_count(const RelaySurface& surface, const LightSource& source) const;
    bool find_point(const RelaySurface& surface, int& tries, Vec3& point);
    bool arrives(int source, const RelaySurface& surface, const Vec3& point, const Vec3& direction);

    Tracer& tracer_;
};

}  // namespace infra
