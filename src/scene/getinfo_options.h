// The options of getinfo.
#pragma once

#include <string>
#include <vector>

#include "common/options.h"

namespace infra {

/// -d and +d: the dimensions instead of the header, or after it.
enum class Dimensions { none, only, too };

struct GetinfoSettings {
    enum class Action { print, append, replace, run };

    Dimensions dimensions = Dimensions::none;
    Action action = Action::print;
    std::vector<std::string> words;  ///< header lines, or the command and its arguments
};

/// The table refers to `settings`, which must outlive it.
OptionTable getinfo_option_table(GetinfoSettings& settings);

}  // namespace infra
