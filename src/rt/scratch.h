// What a Tracer keeps from ray to ray so that tracing does not allocate. Private to the tracer's own files.
#pragma once

#include <vector>

#include "rt/tracer.h"

namespace infra {

/// A sample of a light source: what it would add if nothing stood in the way.
struct Tracer::Contribution {
    int source;
    Vec3 direction;
    double distance;       ///< to the source along the ray
    Spectrum coefficient;  ///< of the source's radiance in the radiance of the surface
    Spectrum value;
    float brightness;
};

/// One stratum of a hemisphere of ambient rays.
struct HemisphereCell {
    Spectrum mean;
    float brightness = 0;
    float variance = 0;
    int neighbours = 0;
};

struct Tracer::Scratch {
    std::vector<Contribution> contributions;  ///< of the direct calculation under way, which never nests
    std::vector<std::uint32_t> order;
    std::vector<float> tail;
    std::vector<std::vector<HemisphereCell>> hemispheres;  ///< by ambient level
};

}  // namespace infra
