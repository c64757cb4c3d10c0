// The photons nearest to a place.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/vec.h"
#include "rt/photons/photon_map.h"

namespace infra {

struct FoundPhoton {
    float distance2;      ///< squared, from the place
    std::uint32_t place;  ///< for PhotonMap::attributes()
};

/// What is looked for. In single precision, as photons are stored.
struct PhotonQuery {
    explicit PhotonQuery(const Vec3& point)
        : position{static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)} {}
    /// Leaves out photons on surfaces that face away from `normal`, or edge-on.
    PhotonQuery& facing(const Vec3& normal) {
        normal_ = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
        any_direction = false;
        return *this;
    }
    PhotonQuery& caustic(bool only) {
        only_caustic = only;
        return *this;
    }
    bool accepts(const PhotonMap::Attributes& photon) const;

    std::array<float, 3> position;
    bool any_direction = true;
    bool only_caustic = false;

  private:
    std::array<float, 3> normal_{0, 0, 0};
};

/// Finds photons, and keeps them until the next search. One a thread: its memory serves all searches.
class PhotonSearch {
  public:
    /// Looks for the `most` photons nearest to the query among those nearer than the root of `limit2`.
    void find(const PhotonMap& map, const PhotonQuery& query, std::size_t most, float limit2);

    /// A heap: the farthest first.
    std::span<FoundPhoton> found() { return {found_.data(), count_}; }
    /// Square of the radius searched: of the farthest photon where as many as asked for are there.
    float radius2() const { return radius2_; }

  private:
    struct Pending;
    void visit_leaf(const PhotonMap& map, const PhotonQuery& query, std::uint32_t node);
    void offer(const PhotonMap& map, const PhotonQuery& query, float distance2, const float* attributes);
    void sift_down(FoundPhoton photon);

    std::vector<FoundPhoton> found_;
    std::size_t most_ = 0;
    std::size_t count_ = 0;
    float radius2_ = 0;
};

}  // namespace infra
