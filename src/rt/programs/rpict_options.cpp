#include "rt/programs/rpict_options.h"

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
    add_zero_option(table, "-pm", "f", "-pm 0.000000", "pixel motion",
                    "motion blur is not built yet, only 0 is taken");
    add_zero_option(table, "-pd", "f", "-pd 0.000000", "pixel depth-of-field",
                    "depth of field is not built yet, only 0 is taken");
    table.integer("-ps", &options.sample_spacing, "pixel sample");
    table.real("-pt", &options.sample_contrast, "pixel threshold");
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
    const std::string sequences = "rendering a sequence of views is not built yet";
    const std::string recovery = "an unfinished picture is never kept, so none can be finished";
    table.unsupported("-S", "i", sequences);
    table.unsupported("-r", "s", recovery);
    table.unsupported("-ro", "s", recovery);
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
    add_output_rows(table, options);
    return table;
}

}  // namespace infra
