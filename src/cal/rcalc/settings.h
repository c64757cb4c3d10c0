// What the command line of rcalc asks for.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cal/library.h"
#include "common/options.h"
#include "record_format.h"

namespace infra::rcalc {

/// How numbers stand in a file. The swapped forms have the other byte order.
enum class NumberForm { text, float32, float32_swapped, float64, float64_swapped };

enum class Passive { off, unmatched, unmatched_and_refused };

struct Settings {
    Settings();

    cal::Library library;
    std::optional<RecordFormat> input_format;
    std::optional<RecordFormat> output_format;
    NumberForm input_form = NumberForm::text;
    NumberForm output_form = NumberForm::text;
    std::size_t binary_columns = 0;              ///< numbers a record, where the input is binary
    std::map<std::string, std::string> presets;  ///< string variables given with -s
    long input_limit = 0;                        ///< records to read from a file, 0: all
    long output_limit = 0;                       ///< records to write for a file, 0: all
    char separator = '\t';
    bool exact_blanks = false;     ///< -b
    bool ignore_newlines = false;  ///< -l
    bool no_input = false;         ///< -n
    bool quiet = false;            ///< -w
    bool unbuffered = false;       ///< -u
    Passive passive = Passive::off;
    std::vector<std::string> files;
};

/// The table refers to `settings`, which must outlive it. Options act in their order, as in RADIANCE.
OptionTable option_table(Settings& settings);

/// Reads the command line.
///   returns  false if -help or -version was answered
///   throws   Error for misuse
bool read_command_line(int argc, char** argv, Settings& settings);

}  // namespace infra::rcalc
