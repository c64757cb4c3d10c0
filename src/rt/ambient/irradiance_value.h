// A cached value: the irradiance of one place, how it changes nearby, and how far it may be used.
#pragma once

#include <cstdint>

#include "common/spectra/spectrum.h"
#include "common/vec.h"

namespace infra {

struct IrradianceValue {
    Vec3 point{0};
    Vec3 normal{0};  ///< of the surface without its textures, on the side that light falls on
    Vec3 axis{0};    ///< of the shorter radius: a unit vector of the surface; the other one is normal x axis
    int level = 0;   ///< diffuse bounces between the eye and the place
    double weight = 1;  ///< 0..1: the finer the hemisphere was sampled, the larger
    double radius[2] = {0,
                        0};  ///< along both axes, at an accuracy of 1: scene units, the first is not longer
    /// Relative change of irradiance: a unit of length along either axis, and a radian of the normal about
    /// it.
    double gradient[2] = {0, 0};
    double turn[2] = {0, 0};
    /// Bit i: something rises near by at an angle from i to i + 1 times pi/16 from `axis` towards the other
    /// axis, so that places there may not see what is seen from here.
    std::uint32_t walls = 0;
    Spectrum radiance;  ///< mean over the hemisphere, irradiance / pi

    explicit IrradianceValue(int channels) : radiance(channels) {}
};

inline constexpr int wall_sectors = 32;

/// Where irradiance is asked for.
struct IrradiancePlace {
    Vec3 point;
    Vec3 normal;          ///< as IrradianceValue's
    Vec3 shading_normal;  ///< with textures, on the same side
    int level = 0;
    double weight = 1;  ///< of the ray that asks
};

/// Decides whether a surface stands between a place and one that has a value.
class WallTest {
  public:
    virtual ~WallTest() = default;
    /// Whether the point cannot be seen from the place.
    virtual bool hides(const Vec3& point) = 0;
};

}  // namespace infra
