// The command line of brdftab.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/options.h"
#include "ir/brdftab/source.h"
#include "nrlbrdf/models.h"

namespace infra::ir {

struct Arguments {
    GridCounts grid{19, 36, 19};
    std::string output;
    std::optional<WavelengthBand> band;  ///< that the output states; without it the source's, if it has one
    std::function<BrdfSource()> make_source;  ///< set by the option that chose it; empty: columns
    std::string source_option;                ///< which one it was
    SampleSettings samples;
    MerlChannel channel = MerlChannel::mean;
    double limit_deg = 0;  ///< largest angle at which an unbounded model is asked; 0: half a step below 90
    bool symmetrize = false;
    bool clamp_energy = false;
    std::string plot;
    bool plot_logarithmic = false;
    std::vector<double> plot_angles;  ///< radians
};

/// `arguments` must outlive the table and stay where it is.
void describe_options(OptionTable& options, Arguments& arguments);

}  // namespace infra::ir
