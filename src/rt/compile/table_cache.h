// What materials share while a scene is compiled: BRDF tables by file, Planck curves by band, the bands
// themselves.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "common/planck/planck_curve.h"
#include "nrlbrdf/distribution.h"
#include "nrlbrdf/spectral_table.h"
#include "rt/compile/scene_bands.h"
#include "rt/lobes/ward_energy.h"

namespace infra {

class Bsdf;

/// The tables of an nrlbrdf material.
struct BrdfTables {
    std::shared_ptr<const TableDistribution> distribution;
    std::shared_ptr<const SpectralTable>
        spectral;  ///< nullptr: the distribution's table is that of all channels
};

struct TableCache {
    std::map<std::pair<double, double>, std::shared_ptr<const PlanckCurve>> planck_curves;

    SceneBands thermal_bands;
    std::map<FacetSlopes, std::shared_ptr<const WardEnergy>> ward_energies;

    std::shared_ptr<const WardEnergy> ward_energy_of(const FacetSlopes& roughness) {
        auto& slot = ward_energies[roughness];
        if (!slot) slot = std::make_shared<const WardEnergy>(roughness);
        return slot;
    }

    /// The curve of a band in um, 0 <= lo < hi.
    std::shared_ptr<const PlanckCurve> planck_curve(double lo_um, double hi_um) {
        auto& slot = planck_curves[{lo_um, hi_um}];
        if (!slot) slot = std::make_shared<const PlanckCurve>(lo_um, hi_um);
        return slot;
    }

    /// By the paths of a material's files, one a line.
    std::map<std::string, BrdfTables, std::less<>> by_path;

    /// By path.
    std::map<std::string, std::shared_ptr<const Bsdf>, std::less<>> bsdfs;
};

}  // namespace infra
