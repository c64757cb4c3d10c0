// Where a table's values come from: an analytic model, measured samples or a MERL file, all as one function.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/brdftab/interpolator.h"
#include "ir/brdftab/merl.h"
#include "ir/brdftab/sample.h"
#include "nrlbrdf/models.h"
#include "nrlbrdf/sea_model.h"

namespace infra::ir {

struct BrdfSource {
    BrdfFunction f;
    std::string description;          ///< one line
    bool bounded = true;              ///< false: infinite somewhere at 90 deg
    bool analytic = false;            ///< a model: quick to ask and smooth
    std::vector<BrdfSample> samples;  ///< as measured, for plots

    std::shared_ptr<const SampleInterpolator> interpolator;  ///< of samples, else null
    std::string notes;                                       ///< what was repaired on the way in, whole lines
    std::function<double(double theta)> emissivity;          ///< the model's own, where it has one
    std::optional<WavelengthBand> band;                      ///< as a table states it
};

/// How text samples become a function.
struct SampleSettings {
    SampleRules rules;
    bool use_reciprocity = false;  ///< each sample stands for its exchanged geometry too
    Extrapolation extrapolation = Extrapolation::constant;
};

enum class SampleLayout { columns, cuts };

/// throw Error with file and line for what cannot be read.
BrdfSource source_from_samples(const std::string& path, SampleLayout layout, const SampleSettings& settings);
BrdfSource source_from_merl(const std::string& path, MerlChannel channel);

/// A table in place of measurements: f is what the renderer interpolates.
BrdfSource source_from_table(const std::string& path);

BrdfSource source_from_sea(const Sea& sea);

}  // namespace infra::ir
