// Where the light of a scene comes from that is not aimed at as a light source: the bright parts of skies,
// suns that are glows, hot plates and flames. Some rays of a hemisphere or lobe are sent there (-gs); the
// rest go as ever, and each counts by the density of all (multiple importance sampling), so that means stay
// as they are.
//
//     const auto guide = Guide::build(*scene, settings);  // nullptr: nothing stands out
//     const Lookout lookout(*guide, point);
//     lookout.sample(u, v);  lookout.pdf(direction);
//
// Only what is much brighter than the mean is aimed at, for the other rays find the rest well enough.
// source: Veach & Guibas, "Optimally Combining Sampling Techniques" (SIGGRAPH 1995), balance heuristic;
// Karlik et al., "MIS Compensation" (SIGGRAPH Asia 2019), densities less their mean.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "common/vec.h"
#include "rt/guiding/direction_map.h"

namespace infra {

class CompiledScene;
struct RenderSettings;

/// Something bright that a ball surrounds, or that fills a cone at infinity.
struct HotSpot {
    Vec3 center{0};     ///< of the ball; distant: unit direction
    double radius = 0;  ///< of the ball; distant: cosine of the cone's half-angle
    double excess = 0;  ///< power above the mean: radiance times projected area; distant: times solid angle
    bool distant = false;
};

class Guide {
  public:
    static constexpr int most_spots = 32;

    /// Looks at every distant source and at every emitting surface of the scene, but not into instances.
    ///   returns  nullptr if nothing is brighter than the rest
    static std::unique_ptr<const Guide> build(const CompiledScene& scene, const RenderSettings& settings);

    /// sky: of what fills large parts of the sphere at infinity, with its integral [radiance * sr], 0 for
    /// none. spots: at most most_spots, each of some excess.
    Guide(DirectionMap sky, double sky_excess, std::vector<HotSpot> spots);

    const DirectionMap& sky() const { return sky_; }
    double sky_excess() const { return sky_excess_; }
    const std::vector<HotSpot>& spots() const { return spots_; }

  private:
    DirectionMap sky_;
    double sky_excess_;
    std::vector<HotSpot> spots_;
};

/// The guide as seen from one point.
class Lookout {
  public:
    Lookout(const Guide& guide, const Vec3& point);

    /// A unit direction towards something bright, for u, v uniform in [0, 1). Strata of u share out the
    /// bright things.
    Vec3 sample(double u, double v) const;
    /// Density [1/sr] of sample(); direction: unit.
    double pdf(const Vec3& direction) const;

  private:
    struct Cone {
        Vec3 axis;
        double least_cosine;
        double density;  ///< chance of the cone over its solid angle [1/sr]
    };
    const Guide& guide_;
    std::array<Cone, Guide::most_spots> cones_;
    std::array<double, Guide::most_spots> chance_;
    int count_ = 0;
    double sky_chance_ = 0;
};

}  // namespace infra
