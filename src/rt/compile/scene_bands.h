// The bands of wavelengths that the thermal surfaces of a scene state.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/data/air_path.h"
#include "common/spectra/channels.h"

namespace infra {

class SceneBands {
  public:
    using Band = std::pair<double, double>;  ///< ends in um

    void add(double lo_um, double hi_um) { bands_.insert({lo_um, hi_um}); }

    /// The band of all thermal surfaces; nothing when there are none or they differ.
    std::optional<Band> common() const;

    /// What cannot be meant: bands that differ in an RGB rendering, also from that of the air; channels in
    /// which surfaces are dark because their band ends.
    ///   air  nullptr for none
    std::vector<std::string> warnings(const Channels& channels, const AirPath* air) const;

  private:
    std::set<Band> bands_;
};

}  // namespace infra
