// Estimates of light from the density of photons.
#pragma once

#include <array>
#include <vector>

#include "common/random.h"
#include "common/vec.h"
#include "rt/photons/photon_maps.h"
#include "rt/photons/photon_search.h"

namespace infra {

/// Red, green, blue.
using PhotonColor = std::array<double, 3>;

/// Estimates, with memory that serves all of them. One a thread.
class PhotonDensity {
  public:
    /// Radiance [W m^-2 sr^-1] of a white Lambertian surface: the irradiance of a place with this normal over
    /// pi. The photons found stand for a disk whose edge is midway between the farthest, which does not count
    /// itself, and the one before.
    ///   only_caustic  of a contribution map
    ///   random        for bias compensation
    PhotonColor surface(const PhotonSource& source, const Vec3& point, const Vec3& normal, bool only_caustic,
                        RandomStream& random);

    /// Radiance that a medium sends to the eye per length of the line of sight and scattering coefficient,
    /// were photons what RADIANCE takes them for; see docs/compatibility.md.
    ///   view          unit, from the eye
    ///   eccentricity  Henyey and Greenstein's
    PhotonColor volume(const PhotonSource& source, const Vec3& point, const Vec3& view, double eccentricity);

  private:
    PhotonColor nearest(const PhotonSource& source, const PhotonQuery& query);
    PhotonColor compensated(const PhotonSource& source, RandomStream& random);

    PhotonSearch search_;
    std::vector<PhotonColor> flux_;  ///< of the nearest one, two, ... photons
};

}  // namespace infra
