// Which value of a record is written where.
#pragma once

#include <string>
#include <vector>

#include "rt/programs/rcontrib/bin_functions.h"
#include "scene/warnings.h"

namespace infra {

/// A file, command or the standard output that values go to.
struct OutputTarget {
    std::string name;             ///< "" is the standard output, "!command" a command
    std::string modifier;         ///< the first of its values
    int bin = 0;                  ///< the same, as its name has it
    bool names_modifier = false;  ///< by %s
    bool names_bin = false;       ///< by %d
    int width = 0, height = 0;    ///< of a picture, 0: it is none

    /// Bins of one modifier that follow one another: numbers as in the record, counting spectra from 0.
    struct Range {
        std::size_t first;
        std::size_t count;
    };
    std::vector<Range> ranges;  ///< in the order in which they are written
    std::size_t size = 0;       ///< spectra a record

    bool is_command() const { return !name.empty() && name.front() == '!'; }
    bool is_file() const { return !name.empty() && !is_command(); }
};

/// A name made of a -o specification: '%s' is the modifier, '%d' (or i, o, x, X, with a width such as %03d)
/// the bin, '%%' a '%'.
struct OutputName {
    std::string text;
    bool names_modifier = false;
    bool names_bin = false;
};
/// throws  Error for other letters after '%', and two of a kind
OutputName output_name(const std::string& specification, const std::string& modifier, int bin);

/// Lays out the outputs. In pictures %d goes on counting where a second modifier has the same name.
///   throws  Error for bad specifications, and for files that exist and may not be written over
std::vector<OutputTarget> plan_outputs(const RcontribSettings& settings, const std::vector<BinRule>& bins,
                                       const WarningSink& warn);

}  // namespace infra
