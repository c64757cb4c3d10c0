// A material that sends light on in one direction, so that a light source seen in a flat surface of it looks
// like another one elsewhere: mirror and prism.
#pragma once

#include "common/vec.h"
#include "rt/sources/light_source.h"

namespace infra {

class Tracer;

/// A flat surface of such a material, within a disk.
struct RelaySurface {
    int surface = -1;
    Vec3 normal{0};     ///< unit, to the front
    double offset = 0;  ///< of the plane along the normal
    RelayDisk disk;
    const LightRelay* relay = nullptr;
};

/// Where a flat surface makes things appear: each point moves along one vector by its distance from the
/// plane. Points of the plane stay where they are, straight lines straight.
struct Projection {
    Vec3 normal{0};  ///< of the plane, unit
    double offset = 0;
    Vec3 shift{0};          ///< of a point at distance 1 before the plane
    bool is_rigid = false;  ///< keeps lengths and angles

    Vec3 vector(const Vec3& v) const { return v + shift * dot(normal, v); }
    Vec3 point(const Vec3& p) const { return p + shift * (dot(normal, p) - offset); }
};

class LightRelay {
  public:
    /// How many images the material makes of one source.
    virtual int image_count() const = 0;

    /// The n-th image of a source. False: the surface makes none.
    virtual bool project(Tracer& tracer, const RelaySurface& surface, const LightSource& source, int n,
                         Projection& image) const = 0;

  protected:
    ~LightRelay() = default;
};

/// The image in the surface just met that a shadow ray is aimed at; nullptr if it goes elsewhere.
const LightSource* image_aimed_at(const Tracer& tracer, const Interaction& at);

}  // namespace infra
