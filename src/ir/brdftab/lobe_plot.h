// Polar diagrams of a table: for each incident angle the lobe in the plane of incidence and the one across
// it, with the measured samples as stars.
#pragma once

#include <string>
#include <vector>

#include "ir/brdftab/sample.h"
#include "nrlbrdf/table.h"

namespace infra::ir {

struct LobePlot {
    std::string title;
    std::vector<double> incident_angles;  ///< radians, one panel each; 1 to 12
    bool logarithmic = false;             ///< radius is log f over at most four decades, else f
};

/// An SVG document. `samples` may be empty; those within half a degree of a panel's incident angle and plane
/// are shown.
std::string draw_lobes(const BrdfTable& table, const std::vector<BrdfSample>& samples, const LobePlot& plot);

/// Incident angles worth a panel: those measured, at most six, evenly chosen.
std::vector<double> measured_incident_angles(const std::vector<BrdfSample>& samples);

}  // namespace infra::ir
