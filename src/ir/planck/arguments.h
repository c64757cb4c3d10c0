// planck's command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/planck/planck_scale.h"

namespace infra::ir {

enum class Direction { radiance, temperature, slope };

struct PlanckArguments {
    std::optional<RadianceScale> scale;  ///< always set after reading
    Direction direction = Direction::radiance;
    bool celsius = false;
    int column = 1;              ///< of the standard input, from 1
    std::vector<double> values;  ///< empty: lines of the standard input instead
};

/// Nothing when -help, -defaults or -version was answered. throws Error for a bad command line.
std::optional<PlanckArguments> read_planck_arguments(int argc, char** argv);

}  // namespace infra::ir
