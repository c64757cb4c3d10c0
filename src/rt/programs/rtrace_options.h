// Everything that rtrace's command line says.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "rt/programs/output_color.h"
#include "rt/programs/output_letters.h"
#include "rt/programs/render_options.h"
#include "scene/warnings.h"

namespace infra {

struct RtraceOptions {
    RenderOptions render = rtrace_defaults();
    int threads = 1;                          ///< -n
    int width = 0;                            ///< -x: of a picture, or rays between flushes
    int height = 0;                           ///< -y
    bool limit_distance = false;              ///< -ld: a ray reaches as far as its direction is long
    bool header = true;                       ///< -h
    bool immediate_irradiance = false;        ///< -I
    NumberFormat input = NumberFormat::text;  ///< -f
    NumberFormat output = NumberFormat::text;
    std::string letters = "v";  ///< -o
    OutputColor color;          ///< -p, -co
    NameFilter tree_filter;     ///< -ti -te

    /// Rays after which input ends, 0: no limit.
    std::uint64_t ray_limit() const;
    /// Rays after which output is flushed, 0: never.
    std::uint64_t flush_interval() const { return height <= 0 || width <= 1 ? std::max(width, 0) : 0; }
};

/// rtrace's option table, in the order of RADIANCE's -defaults. `options` must outlive it.
OptionTable rtrace_option_table(RtraceOptions& options);

/// Understands -o together with what the other options ask for.
///   throws  Error for letters that don't exist or that don't go with -f, -i or -I
OutputSpec output_spec(const RtraceOptions& options, const WarningSink& warn);

}  // namespace infra
