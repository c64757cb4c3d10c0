#include "rt/programs/rpict_options.h"

#include <optional>

#include "common/format.h"
#include "common/views/view_options.h"

namespace infra {
namespace {

/// RADIANCE puts two blanks after these spellings.
std::string spread(const char* spelling, int value) { return formatted("%s  %-9d", spelling, value); }

void add_pixel_rows(OptionTable& table, RpictOptions& options) {
    add_primaries_rows(table, options.color);
    table.real("-pa", &options.pixel_aspect, "pixel aspect ratio").at_least(0);
    table.real("-pj", &options.pixel_jitter, "pixel jitter");
    table.real("-pm", &options.motion_blur, "pixel motion");
    table.real("-pd", &options.lens_diameter, "pixel depth-of-field")
        .differing("in a parallel view the lens moves along with the ray");
    table.integer("-ps", &options.sample_spacing, "pixel sample");
    table.real("-pt", &options.sample_contrast, "pixel threshold");
    table
        .integer("-spp", &options.samples_per_pixel,
                 "samples of every pixel, whose mean it is, in place of -ps and -pt; 0: none")
        .at_least(0)
        .unlisted()
        .ours();
}

SplitSettings& split_settings(RpictOptions& options) {
    std::optional<SplitSettings>& split = options.render.settings.split;
    return split ? *split : split.emplace();
}

void add_split_rows(OptionTable& table, RpictOptions& options) {
    table
        .custom(
            "-split", "s",
            [&options](const OptionValues& given) {
                options.split_output = given.text(0);
                split_settings(options);
            },
            "file for the picture told apart by where its radiance comes from, .exr: emitted, path, assumed "
            "and "
            "reflected_sky, _sea, _sun and _ship")
        .named("file.exr")
        .ours();
    table
        .custom(
            "-splitb", "i",
            [&options](const OptionValues& given) { split_settings(options).bounces = given.integer(0); },
            "bounces that -split tells apart, the last with all beyond it")
        .named("bounces")
        .at_least(1)
        .ours();
    table
        .custom(
            "-splitm", "ss",
            [&options](const OptionValues& given) {
                const std::optional<Origin> origin = origin_named(given.text(0));
                if (!origin) given.reject("what a modifier is must be sky, sea, sun or ship");
                split_settings(options).modifiers.push_back({*origin, given.text(1)});
            },
            "for -split: what surfaces of this modifier are; sources are sky or sea, narrow ones the sun, "
            "all "
            "else is ship")
        .named("sky|sea|sun|ship modifier")
        .ours();
}

void add_output_rows(OptionTable& table, RpictOptions& options) {
    add_spectrum_row(table, options.color, options.render.channel_count).unlisted().ours().help =
        "write RADIANCE's spectral format, one value a channel";
    table
        .text("-o", &options.output,
              "picture file; .exr is written as float OpenEXR with all channels, .hsr as spectra")
        .named("file")
        .differing(
            "replaced when the picture is complete, where RADIANCE's must not exist and grows; endings of "
            "other "
            "formats are refused");
    table.text("-z", &options.depth_output, "file for the distances of the pixels, raw floats").named("file");
    table
        .text("-se", &options.error_output,
              "file for the standard errors of the pixels' values, .exr; needs -spp 2 or more")
        .named("file.exr")
        .ours();
    add_split_rows(table, options);
    table
        .custom(
            "-S", "i", [&options](const OptionValues& given) { options.first_number = given.integer(0); },
            "a sequence: a picture for each view on the standard input, numbered from here; %d in the names "
            "of -o and -z is the number")
        .named("number")
        .differing("a view line that is not understood is an error; an empty file takes a frame");
    table
        .text("-r", &options.recover,
              "finish the unfinished picture in this file, or with -S the one with this number")
        .named("file|number")
        .differing("what our own rpict left comes out as if it had never been stopped");
    table
        .custom(
            "-ro", "s",
            [&options](const OptionValues& given) { options.recover = options.output = given.text(0); },
            "the same as -r file -o file")
        .named("file")
        .differing("the same; a file that is no picture is refused and stays");
}

}  // namespace

OptionTable rpict_option_table(RpictOptions& options) {
    const RpictOptions* const o = &options;
    OptionTable table("rpict", "[octree]");
    table.read_environment("RENDER_OPTIONS");
    add_view_options(table, options.view);
    table.integer("-x", &options.width, "x resolution").at_least(1).shown([o] {
        return spread("-x", o->width);
    });
    table.integer("-y", &options.height, "y resolution").at_least(1).shown([o] {
        return spread("-y", o->height);
    });
    add_pixel_rows(table, options);
    table.integer("-t", &options.report_seconds, "time between reports").shown([o] {
        return spread("-t", o->report_seconds);
    });
    add_warning_option(table, options.render);
    add_render_options(table, options.render);
    table.integer("-n", &options.threads, "number of threads, 0: all cores").at_least(0).ours();
    table
        .real("-ck", &options.checkpoint_seconds,
                 "seconds between checkpoints, which keep in name.partial what is traced so far; 0: none")
        .at_least(0)
        .unlisted()
        .ours();
    add_output_rows(table, options);
    return table;
}

}  // namespace infra
