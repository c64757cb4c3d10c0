#include "rt/programs/render_options.h"

#include <algorithm>

#include "common/format.h"
#include "common/raypath.h"
#include "common/text_file.h"

namespace infra {
namespace {

void add_names(NameFilter& filter, NameFilter::Mode mode, const std::vector<std::string>& names) {
    if (filter.mode != mode) filter = {mode, {}};
    filter.names.insert(filter.names.end(), names.begin(), names.end());
}

void add_direct_rows(OptionTable& table, RenderOptions& options) {
    RenderSettings& settings = options.settings;
    table.real("-dt", &settings.shadow_threshold, "direct threshold");
    table.real("-dc", &settings.shadow_certainty, "direct certainty")
        .differing(
            "lights beyond -dt are judged by one test in each group at the same point, not by past rays");
    table.real("-dj", &settings.source_jitter, "direct jitter")
        .differing("samples on round lights are evenly spread");
    table.real("-ds", &settings.source_size_ratio, "direct sampling");
    table.integer("-dr", &settings.direct_relays, "direct relays")
        .differing("images of images are dropped only if no straight line passes all mirrors");
    table.integer("-dp", &settings.direct_pretest, "direct pretest density")
        .differing("fixed rays, not random ones; shadows between mirror and lamp are always followed");
    table.toggle("-dv", &settings.sources_visible, "direct visibility");
}

/// Three numbers, as -defaults lists them: three times `number`.
void add_color_row(OptionTable& table, const char* spelling, float (&target)[3], const char* number,
                   const char* help) {
    table
        .custom(
            spelling, "fff",
            [&target](const OptionValues& given) {
                for (std::size_t c = 0; c < 3; ++c) target[c] = static_cast<float>(given.real(c));
            },
            help)
        .named("red green blue")
        .shown([&target, number, spelling = std::string(spelling)] {
            std::string text = spelling;
            for (const float value : target) text += " " + formatted(number, double(value));
            return text;
        });
}

void add_ambient_rows(OptionTable& table, RenderOptions& options) {
    RenderSettings& settings = options.settings;
    add_color_row(table, "-av", settings.ambient_value, "%f", "ambient value");
    table.integer("-aw", &settings.ambient_value_weight, "ambient value weight");
    table.integer("-ab", &settings.ambient_bounces, "ambient bounces");
    table.real("-aa", &settings.ambient_accuracy, "ambient accuracy")
        .differing(
            "above 0 the threads share one cache, and even light has no gradient: what differs is listed "
            "under "
            "irradiance in compatibility.md");
    table.integer("-ar", &settings.ambient_resolution, "ambient resolution");
    table.integer("-ad", &settings.ambient_divisions, "ambient divisions")
        .differing("above 1048576 with -aa above 0: 1048576");
    table.integer("-as", &settings.ambient_super_samples, "ambient super-samples");
    table
        .custom(
            "-af", "s", [&settings](const OptionValues& given) { settings.ambient_file = given.text(0); },
            "ambient file: cached values of other runs are read, new ones added")
        .named("file")
        .differing("a damaged file is refused and left as it is, not cut off at the first bad value");
    add_name_filter(table, "-a", settings.ambient_filter, "in indirect light");
    table
        .real("-gs", &settings.guided_samples,
              "guided samples: rays of a hemisphere or lobe sent to bright sky and hot surfaces")
        .unlisted()
        .at_least(0)
        .ours();
}

void add_mist_rows(OptionTable& table, RenderSettings& settings) {
    add_color_row(table, "-me", settings.extinction, "%.2e", "mist extinction coefficient");
    add_color_row(table, "-ma", settings.scattering_albedo, "%f", "mist scattering albedo");
    table.real("-mg", &settings.scattering_eccentricity, "mist scattering eccentricity");
    table.real("-ms", &settings.medium_step, "mist sampling distance");
}

void add_air_row(OptionTable& table, RenderSettings& settings) {
    table
        .custom(
            "-mp", "s", [&settings](const OptionValues& given) { settings.air_path = given.text(0); },
            "medium path: transmittance and radiance of the air along camera rays")
        .named("file")
        .ours();
}

void add_channel_rows(OptionTable& table, RenderOptions& options) {
    const RenderOptions* const o = &options;
    const auto shown_if_spectral = [o](const std::string& text) {
        return o->channel_count > Channels::fewest ? text : "";
    };
    table.integer("-cs", &options.channel_count, "number of spectral bins")
        .at_least(Channels::fewest)
        .shown([=] { return shown_if_spectral(formatted("-cs %-2d", o->channel_count)); });
    table
        .custom(
            "-cw", "ff",
            [&options](const OptionValues& given) {
                for (int i = 0; i < 2; ++i) options.wavelength_ends[i] = given.real(i);
            },
            "wavelength limits (nm)")
        .named("nmA nmB")
        .differing(
            "a range that does not reach red, green and blue gives the means of its thirds with a warning; "
            "with "
            "-cs 3 three bands")
        .shown([=] {
            const bool given = o->wavelength_ends[0] != 0 || o->wavelength_ends[1] != 0;
            return shown_if_spectral(
                given ? formatted("-cw %3.0f %3.0f", o->wavelength_ends[1], o->wavelength_ends[0])
                      : "-cw 380 780");  // in that order: RADIANCE's
        });
}

void add_limit_rows(OptionTable& table, RenderSettings& settings) {
    constexpr double fewest = -1e6;  // its negative is a count too
    table.integer("-lr", &settings.max_reflections, "limit reflection").at_least(fewest).remark([&settings] {
        return std::string("limit reflection") + (settings.max_reflections <= 0 ? " (Russian roulette)" : "");
    });
    table.real("-lw", &settings.min_weight, "limit weight", true);
}

/// -e and -f as far as both programs know them: definitions of the functions that scenes use, and the error
/// file.
void add_definition_rows(OptionTable& table, RenderOptions& options) {
    table
        .custom(
            "-e", "s",
            [&options](const OptionValues& given) {
                const std::string& text = given.text(0);
                if (text.find_first_of("=:") == std::string::npos)
                    options.error_file = text;
                else
                    options.definitions.push_back({text, false});
            },
            "definitions for function files, or a file for messages")
        .named("text|file");
    table
        .custom(
            "-f", "s",
            [&options](const OptionValues& given) {
                options.definitions.push_back({given.text(0), true});
            },
            "file of definitions")
        .named("file.cal");
}

void add_persistence_rows(OptionTable& table, RenderOptions& options) {
    const auto set_file = [&options](const OptionValues& given) { options.persist_file = given.text(0); };
    table
        .custom(
            "-P", "s", set_file,
            "serve commands that name the same file from one copy of the scene, until killed or idle for 8 "
            "hours")
        .named("file")
        .differing("each command has a process forked from one server that holds the scene");
    table.custom("-PP", "s", set_file, "the same as -P")
        .named("file")
        .differing("each command has a process forked from one server that holds the scene");
}

void take_photon_map(RenderSettings& settings, const OptionValues& given) {
    constexpr std::size_t most_maps = 6;  // as many as there are kinds
    if (settings.photon_maps.size() == most_maps) given.reject("too many photon maps");
    PhotonMapRequest request{given.text(0)};
    if (given.values.size() > 1) {
        request.fewest = request.most = given.integer(1);
        if (request.fewest < 1) given.reject("the bandwidth, a number of photons, must be at least 1");
    }
    if (given.values.size() > 2) {
        request.most = given.integer(2);
        if (request.most <= request.fewest) given.reject("the second bandwidth must be above the first");
    }
    if (request.most > most_samples) given.reject("too many photons for one estimate");
    if (settings.ambient_bounces == 0) settings.ambient_bounces = 1;  // whoever gives a map wants its light
    settings.photon_maps.push_back(std::move(request));
}

void add_photon_rows(OptionTable& table, RenderSettings& settings) {
    table
        .custom(
            "-ap", "sii", [&settings](const OptionValues& given) { take_photon_map(settings, given); },
            "photon map of mkpmap, and photons an estimate takes; from one number to another to compensate "
            "bias")
        .optional_after(1)
        .named("file [bandwidth [largest]]")
        .differing("without -am the search radius is always that which RADIANCE starts from");
    add_photon_search_rows(table, settings);
}

void add_seed_row(OptionTable& table, RenderSettings& settings) {
    table
        .custom(
            "-seed", "i",
            [&settings](const OptionValues& given) {
                settings.seed = static_cast<std::uint64_t>(given.integer(0));
            },
            "number of the random streams: another one, other noise")
        .named("number")
        .at_least(0)
        .ours();
}

void add_refused_rows(OptionTable& table) { table.unsupported("-features", "", "-help lists what there is"); }

}  // namespace

void add_photon_search_rows(OptionTable& table, RenderSettings& settings) {
    table
        .custom(
            "-am", "f",
            [&settings](const OptionValues& given) {
                if (given.real(0) <= 0) given.reject("the radius must be above 0");
                settings.photon_radius = given.real(0);
            },
            "max photon search radius")
        .named("radius")
        .shown([&settings] { return formatted("-am %.1f", settings.photon_radius); });
    const auto positive = [](const OptionValues& given) {
        if (given.real(0) <= 0) given.reject("the ratio must be above 0");
    };
    table.custom("-ac", "f", positive, "photon cache page size ratio")
        .named("ratio")
        .differing("no effect: maps are held in memory");
    table
        .custom(
            "-aC", "s", [](const OptionValues&) {}, "num cached photons")
        .named("count")
        .differing("no effect: maps are held in memory");
}

Channels RenderOptions::channels() const {
    const Channels bands = band_channels();
    return settings.split ? bands.with_components(settings.split->component_count()) : bands;
}

Channels RenderOptions::band_channels() const {
    const bool given = wavelength_ends[0] != 0 || wavelength_ends[1] != 0;
    if (!given && channel_count == 3) return {};
    const double nm_a = given ? wavelength_ends[0] : Channels::blue_limit_nm;
    const double nm_b = given ? wavelength_ends[1] : Channels::red_limit_nm;
    const Channels spectral =
        Channels::spectral(std::min(channel_count, Channels::most), nm_a, nm_b);  // as RADIANCE
    return channel_count == 3 && spectral.shows_colors() ? Channels() : spectral;
}

RenderOptions rpict_defaults() {
    RenderOptions options;
    options.settings.ambient_accuracy = 0.2;
    return options;
}

RenderOptions rtrace_defaults() {
    RenderOptions options;
    RenderSettings& settings = options.settings;
    settings.shadow_threshold = 0.03;
    settings.shadow_certainty = 0.75;
    settings.source_size_ratio = 0.2;
    settings.ambient_divisions = 1024;
    settings.ambient_super_samples = 512;
    settings.max_reflections = -10;
    options.uncorrelated = true;
    settings.direct_relays = 2;
    settings.ambient_accuracy = 0.1;
    settings.ambient_resolution = 256;
    return options;
}

RenderOptions rcontrib_defaults() {
    RenderOptions options;
    RenderSettings& settings = options.settings;
    settings.shadow_threshold = 0;
    settings.shadow_certainty = 0.75;
    settings.source_jitter = 0.9;
    settings.source_size_ratio = 0.2;
    settings.direct_relays = 3;
    settings.specular_threshold = 0.02;
    settings.ambient_bounces = 1;
    settings.ambient_accuracy = 0;
    settings.ambient_resolution = 256;
    settings.ambient_divisions = 350;
    settings.ambient_super_samples = 0;
    settings.max_reflections = -10;
    settings.min_weight = 2e-3;
    options.uncorrelated = true;
    return options;
}

void add_warning_option(OptionTable& table, RenderOptions& options) {
    table.toggle("-w", &options.warnings, "warning messages");
}

void add_transport_options(OptionTable& table, RenderOptions& options) {
    RenderSettings& settings = options.settings;
    table.toggle("-i", &settings.irradiance, "irradiance calculation");
    table
        .toggle("-u", &options.uncorrelated, "uncorrelated Monte Carlo sampling",
                "correlated quasi-Monte Carlo sampling")
        .differing("no effect: samples are stratified within a hemisphere and independent from ray to ray");
    table.toggle("-bv", &settings.back_faces_visible, "back face visibility");
    add_direct_rows(table, options);
    table.real("-ss", &settings.specular_samples, "specular sampling");
    table.real("-st", &settings.specular_threshold, "specular threshold");
    add_ambient_rows(table, options);
    add_mist_rows(table, settings);
    add_air_row(table, settings);
    add_channel_rows(table, options);
    add_limit_rows(table, settings);
    add_definition_rows(table, options);
}

void add_render_options(OptionTable& table, RenderOptions& options) {
    add_transport_options(table, options);
    add_persistence_rows(table, options);
    add_photon_rows(table, options.settings);
    add_last_rows(table, options);
}

void add_last_rows(OptionTable& table, RenderOptions& options) {
    add_seed_row(table, options.settings);
    table.toggle("-stats", &options.statistics, "count of rays by kind, on stderr").unlisted().ours();
    add_refused_rows(table);
}

void add_name_filter(OptionTable& table, const std::string& prefix, NameFilter& filter,
                     const std::string& what) {
    const auto add_pair = [&](NameFilter::Mode mode, const char* letters, const std::string& verb) {
        table
            .custom(
                prefix + letters[0], "s",
                [&filter, mode](const OptionValues& given) { add_names(filter, mode, {given.text(0)}); },
                verb + " this modifier " + what)
            .named("name");
        table
            .custom(
                prefix + letters[1], "s",
                [&filter, mode](const OptionValues& given) {
                    const std::string path = require_library_file(given.text(0), "list of modifiers");
                    add_names(filter, mode, split_words(read_text_file(path)));
                },
                verb + " the modifiers in this file " + what)
            .named("file");
    };
    add_pair(NameFilter::Mode::include, "iI", "only");
    add_pair(NameFilter::Mode::exclude, "eE", "without");
}

}  // namespace infra
