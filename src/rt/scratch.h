// What a Tracer keeps from ray to ray so that tracing does not allocate. Private to the tracer's own files.
#pragma once

#include <vector>

#include "rt/ambient/hemisphere_cells.h"
#include "rt/ambient/hemisphere_mesh.h"
#include "rt/photons/photon_density.h"
#include "rt/sources/brightest_first.h"
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

/// What a hemisphere whose irradiance is cached has seen through its strata, and where.
struct HemisphereView {
    std::vector<HemisphereCell> cells;
    std::vector<MeshCorner> corners;
};

struct Tracer::Scratch {
    std::vector<Contribution> contributions;  ///< of the direct calculation under way, which never nests
    std::vector<Ranked> order, spare_order;
    std::vector<float> tail;
    std::vector<std::vector<HemisphereCell>> hemispheres;  ///< by ambient level
    std::vector<HemisphereView> views;                     ///< the same
    PhotonDensity photons;
};

}  // namespace infra
