#include "rt/programs/rpict.h"

#include <algorithm>
#include <string>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"
#include "rt/programs/ambient_setup.h"
#include "rt/programs/picture_output.h"
#include "rt/programs/render_frame.h"
#include "rt/programs/rpict_options.h"

namespace infra {
namespace {

constexpr int widest_spacing = 16;
constexpr double most_pixels = 1e9;

/// Size and sampling of the picture; the resolution is fitted to the view.
FrameOptions frame_options(RpictOptions& options, const WarningSink& warn) {
    int spacing = std::max(options.sample_spacing, 1);
    if (spacing > widest_spacing) {
        warn(formatted("pixel sampling reduced from %d to %d", spacing, widest_spacing));
        spacing = widest_spacing;
    }
    fit_resolution(view_aspect(options.view), options.pixel_aspect, options.width, options.height);
    if (static_cast<double>(options.width) * options.height > most_pixels)
        throw Error(formatted("a picture of %d x %d pixels is too large", options.width, options.height));
    return {.width = options.width,
            .height = options.height,
            .pixel_jitter = options.pixel_jitter,
            .sample_spacing = spacing,
            .sample_contrast = options.sample_contrast,
            .want_depth = !options.depth_output.empty()};
}

}  // namespace

int rpict(int argc, char** argv) {
    RpictOptions options;
    OptionTable table = rpict_option_table(options);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;
    if (operands->size() > 1)
        throw Error("command line error at '" + operands->front() + "': one octree at a time");
    set_up_view(options.view);
    redirect_messages(options.render.error_file, table.command_line());
    const WarningSink warn = warning_sink(table.program(), options.render);
    check_writable(options);
    const Channels channels = options.render.channels();
    if (const std::string text = color_warning(options.color, channels);
        writes_colors(options) && !text.empty())
        warn(text);

    const LoadedScene loaded = load_scene(operands->empty() ? "" : operands->front(), options.render, warn);
    for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    FrameOptions size = frame_options(options, warn);
    const auto cache = open_irradiance_cache(loaded, options.render, table.program(),
                                             operands->empty() ? "" : operands->front(), warn);
    size.cache = cache.get();
    const InterruptGuard guard;
    Workers workers(options.threads);
    Progress progress(table.program(), static_cast<std::uint64_t>(size.width) * size.height,
                      options.report_seconds);
    TracerFaults faults;
    Frame frame =
        render_frame(*loaded.scene, options.render.settings, options.view, size, workers, progress, faults);
    progress.finish();
    if (cache) cache->flush();
    throw_if_interrupted();

    write_frame(std::move(frame), *loaded.scene, options, header_lines(loaded.header, table.command_line()),
                table.command_line());
    faults.report(warn);
    return 0;
}

}  // namespace infra
