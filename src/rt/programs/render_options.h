// The options that rpict and rtrace share: what light transport is computed, and how finely.
#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "rt/compile/compiled_scene.h"
#include "rt/settings.h"

namespace infra {

struct RenderOptions {
    RenderSettings settings;
    std::vector<FunctionDefinition> definitions;  ///< -e, -f, in order
    std::string error_file;                       ///< -e without a definition: stderr goes there
    std::string persist_file;                     ///< -P, -PP; empty: none
    bool warnings = true;                         ///< -w
    bool statistics = false;                      ///< -stats
    int channel_count = 3;                        ///< -cs
    double wavelength_ends[2] = {0, 0};           ///< -cw, nm; 0: not given

    /// What -cs, -cw and -split ask for. throws Error as Channels::spectral and Channels::with_components.
    Channels channels() const;
    bool uncorrelated = false;  ///< -u: accepted, every ray's samples are independent

  private:
    Channels band_channels() const;
};

/// What the programs start from.
RenderOptions rpict_defaults();
RenderOptions rtrace_defaults();
RenderOptions rcontrib_defaults();

/// Adds -w; rpict and rtrace list it in different places.
void add_warning_option(OptionTable& table, RenderOptions& options);

/// Adds the shared rows in the order of RADIANCE's -defaults. `options` must outlive the table, here and
/// below.
void add_render_options(OptionTable& table, RenderOptions& options);
/// The first of these: what light transport is computed, and definitions of functions. Neither persistence
/// nor photon maps.
void add_transport_options(OptionTable& table, RenderOptions& options);
/// How photons are looked for: -am, -ac, -aC.
void add_photon_search_rows(OptionTable& table, RenderSettings& settings);
/// The last of them: -seed, and what is refused.
void add_last_rows(OptionTable& table, RenderOptions& options);

/// Adds <prefix>i, <prefix>I, <prefix>e and <prefix>E: names, or files of names found through RAYPATH, to
/// include or to exclude. The last kind given wins. `filter` must outlive the table.
///   what   of which modifiers, "in indirect light"
void add_name_filter(OptionTable& table, const std::string& prefix, NameFilter& filter,
                     const std::string& what);

}  // namespace infra
