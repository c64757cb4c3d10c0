#include "rt/programs/rpict.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"
#include "common/version.h"
#include "rt/programs/render_frame.h"
#include "rt/programs/rpict_options.h"

namespace infra {
namespace {

constexpr int widest_spacing = 16;
constexpr double most_pixels = 1e9;
/// RADIANCE's standard primaries, which tell other programs that the channels are its RGB.
constexpr const char* standard_primaries =
    "PRIMARIES= 0.6400 0.3300 0.2900 0.6000 0.1500 0.0600 0.3333 0.3333";

bool is_exr(const std::string& path) { return path.ends_with(".exr") || path.ends_with(".EXR"); }

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

/// No date among the lines: the same command gives the same file.
PictureHeader picture_header(const std::vector<std::string>& first_lines, const RpictOptions& options) {
    PictureHeader header;
    header.lines = first_lines;
    header.add("VIEW=" + format_view(options.view));
    if (options.pixel_aspect < 0.995 || options.pixel_aspect > 1.005)
        header.add(formatted("PIXASPECT=%f", options.pixel_aspect));
    header.add(standard_primaries);
    return header;
}

/// Fails now rather than after hours of work if a file cannot be written.
/// Before hours of work, not after. Pipes and devices are left alone: opening them has consequences.
void check_writable(const std::string& path) {
    struct stat status {};
    const bool exists = stat(path.c_str(), &status) == 0;
    if (!path.empty() && (!exists || S_ISREG(status.st_mode))) AtomicFile probe(path);
}

void write_depth(const std::string& path, const std::vector<float>& depth) {
    AtomicFile file(path);
    std::fwrite(depth.data(), sizeof(float), depth.size(), file.stream());
    file.commit();
}

ExrDescription describe(const RpictOptions& options, const std::string& command_line) {
    const bool irradiance = options.render.settings.irradiance;
    return {.program = command_line,
            .view = format_view(options.view),
            .quantity = irradiance ? "irradiance" : "radiance",
            .unit = irradiance ? "W.m-2" : "W.m-2.sr-1",
            .band = {},
            .software = version_string()};
}

void write_picture(const std::string& path, const Picture& picture, const ExrDescription& description) {
    if (is_exr(path)) {
        write_exr(path, picture, description);
    } else if (!path.empty()) {
        write_hdr(path, picture);
    } else {
        HdrWriter writer(stdout, picture.header, picture.width, picture.height);
        const std::size_t row = static_cast<std::size_t>(picture.width) * picture.channels;
        for (int y = 0; y < picture.height; ++y)
            writer.write_scanline(std::span(picture.pixels).subspan(y * row, row));
        writer.finish();
    }
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
    check_writable(options.output);
    check_writable(options.depth_output);

    const LoadedScene loaded = load_scene(operands->empty() ? "" : operands->front(), options.render, warn);
    for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    const FrameOptions size = frame_options(options, warn);
    const InterruptGuard guard;
    Workers workers(options.threads);
    Progress progress(table.program(), static_cast<std::uint64_t>(size.width) * size.height,
                      options.report_seconds);
    TracerFaults faults;
    Frame frame =
        render_frame(*loaded.scene, options.render.settings, options.view, size, workers, progress, faults);
    progress.finish();
    throw_if_interrupted();

    frame.picture.header = picture_header(header_lines(loaded.header, table.command_line()), options);
    if (!options.depth_output.empty()) write_depth(options.depth_output, frame.depth);
    write_picture(options.output, frame.picture, describe(options, table.command_line()));
    faults.report(warn);
    return 0;
}

}  // namespace infra
