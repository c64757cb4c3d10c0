// The photon maps of a render, what is looked up in each, and which light each stands for.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rt/photons/photon_map.h"
#include "rt/settings.h"

namespace infra {

/// A map, and how many photons an estimate takes.
struct PhotonSource {
    PhotonMap photons;
    int fewest, most;  ///< differ where bias is compensated
    float limit2;      ///< square of the radius within which photons count
};

class PhotonMaps {
  public:
    /// Reads the maps of the settings. Of several of one kind the last counts.
    ///   throws  Error for files that are no maps, and for what their kind can't do
    PhotonMaps(const RenderSettings& settings, std::vector<std::string>& warnings);

    /// What ends a diffuse bounce: a contribution, precomputed or global map; nullptr for none. A
    /// contribution map also stands for caustics, by its marked photons.
    const PhotonSource* indirect() const;
    /// Light focused on surfaces seen by the eye: a contribution or caustic map.
    const PhotonSource* caustic() const;
    const PhotonSource* volume() const { return of(PhotonKind::volume); }
    const PhotonSource* direct() const { return of(PhotonKind::direct); }

    /// Whether paths that end on surfaces are in a map: those with a specular part are then not followed from
    /// diffuse surfaces on, and mirrors make no virtual sources.
    bool cover_surfaces() const { return indirect() || caustic(); }
    /// Whether diffuse bounces then end even at panes: with a map of caustics alone.
    bool cover_transmission() const { return of(PhotonKind::caustic) != nullptr; }
    /// Whether light of sources that passes through something before it arrives is in a map.
    bool cover_transmitted_light() const { return covers_transmitted_light_; }

  private:
    const PhotonSource* of(PhotonKind kind) const {
        const auto& source = sources_[static_cast<std::size_t>(kind)];
        return source ? &*source : nullptr;
    }

    std::array<std::optional<PhotonSource>, photon_kinds> sources_;
    bool covers_transmitted_light_ = false;
};

}  // namespace infra
