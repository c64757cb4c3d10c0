// Everything that rcontrib's command line says. What was said of outputs and bins before an -m goes with that
// modifier.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rt/programs/render_options.h"
#include "rt/programs/value_writer.h"

namespace infra {

/// -m, or a name of a file given with -M.
struct TrackedModifier {
    std::string name;
    std::optional<std::string> output;  ///< -o, nothing: the standard output
    std::string parameters;             ///< -p
    std::string bin;                    ///< -b
    std::string bin_count;              ///< -bn, empty: not given
    std::string count_parameters;       ///< -p before it
    std::size_t count_definitions = 0;  ///< how many -e and -f stand before it
    int width = 0, height = 0;          ///< -x and -y before it
};

struct RcontribSettings {
    RenderOptions render = rcontrib_defaults();
    int threads = 1;                          ///< -n
    int width = 0;                            ///< -x: of a picture, or records between flushes
    int height = 0;                           ///< -y
    int accumulate = 1;                       ///< -c: rays a record, 0: all of them
    bool contributions = false;               ///< -V: radiance that arrives, not coefficients
    bool immediate_irradiance = false;        ///< -I
    bool limit_distance = false;              ///< -ld
    bool header = true;                       ///< -h
    bool force = false;                       ///< -fo: existing files are written over
    bool recover = false;                     ///< -r
    int report_seconds = 0;                   ///< -t
    NumberFormat input = NumberFormat::text;  ///< -f
    NumberFormat output = NumberFormat::text;
    std::vector<TrackedModifier> modifiers;

    TrackedModifier next{.bin = "0"};  ///< what -o, -b, -bn and -p have said so far

    /// Whether the outputs are pictures of this size.
    bool has_size() const { return width > 0 && height > 0; }
    /// Records after which input ends, 0: no limit.
    std::uint64_t record_limit() const;
    /// The same in rays.
    std::uint64_t ray_limit() const;
    /// Records after which output is flushed, 0: never.
    int flush_interval() const { return height > 0 && width > 1 ? 0 : width; }
    /// What is as it must be whatever was said: no shadow is guessed, nothing interpolated.
    void apply_overrides();
};

/// rcontrib's option table, in the order of RADIANCE's -defaults. `settings` must outlive it.
OptionTable rcontrib_option_table(RcontribSettings& settings);

/// A "name=value" of -p.
struct BinParameter {
    std::string name;
    double value;
};

/// Takes "MF=4,RHS=+1" apart; ',', ';', ':' and blanks stand between.
///   throws  Error for anything else
std::vector<BinParameter> parse_parameters(const std::string& text);

}  // namespace infra
