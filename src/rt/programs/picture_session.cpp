#include "rt/programs/picture_session.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"
#include "rt/programs/frame_name.h"
#include "rt/programs/frame_setup.h"
#include "rt/programs/picture_output.h"

namespace infra {
namespace {

constexpr double most_pixels = 1e9;

/// The options as this one picture has them: its view, its size, its files.
RpictOptions options_of(const RpictOptions& all, int number, const View& view,
                        const std::optional<Recovery>& recovery) {
    RpictOptions options = all;
    options.view = view;
    options.output = frame_name(all.output, number);
    options.depth_output = frame_name(all.depth_output, number);
    options.error_output = frame_name(all.error_output, number);
    options.split_output = frame_name(all.split_output, number);
    if (recovery) {
        options.width = recovery->partial.width;
        options.height = recovery->partial.height;
        options.pixel_aspect = recovery->partial.pixel_aspect;
    }
    // A size found in a file stays: it goes with the pixel aspect there, or with none.
    if (!recovery || options.pixel_aspect == 0)
        fit_resolution(view_aspect(view), options.pixel_aspect, options.width, options.height);
    if (static_cast<double>(options.width) * options.height > most_pixels)
        throw Error(formatted("a picture of %d x %d pixels is too large", options.width, options.height));
    return options;
}

bool is_plain_file(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// A device or pipe cannot be gone on with.
bool can_be_resumed(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

/// Where an unfinished picture is kept for later; "": nowhere.
std::string place_to_keep(const RpictOptions& options) {
    const bool has_name = !options.output.empty() && can_be_resumed(options.output);
    return has_name ? partial_name(options.output) : std::string();
}

/// Whether a name, followed through links, is the file that the picture went to ("": the standard output).
bool is_output(const std::string& path, const std::string& output) {
    struct stat named {
    }, written{};
    const int found = output.empty() ? fstat(STDOUT_FILENO, &written) : stat(output.c_str(), &written);
    return found == 0 && stat(path.c_str(), &named) == 0 && named.st_dev == written.st_dev &&
           named.st_ino == written.st_ino;
}

}  // namespace

PictureSession::PictureSession(const LoadedScene& loaded, const RpictOptions& options, IrradianceCache* cache,
                               Distribution* distribution, const std::string& program,
                               const std::string& command_line, const WarningSink& warn)
    : loaded_(loaded),
      options_(options),
      cache_(cache),
      distribution_(distribution),
      program_(program),
      command_line_(command_line),
      warn_(warn),
      workers_(options.threads) {
    if (options.sample_spacing > widest_spacing)
        warn(formatted("pixel sampling reduced from %d to %d", options.sample_spacing, widest_spacing));
}

std::string PictureSession::fingerprint_of(const View& view, const std::optional<View>& previous) const {
    if (!distribution_) return {};
    Fingerprint fingerprint = distribution_->fingerprint;
    fingerprint.add_view(view);
    if (previous) fingerprint.add_view(*previous);
    return fingerprint.text();
}

bool PictureSession::has_own(int number, const View& view, const std::optional<View>& previous) const {
    const std::string path = place_to_keep(options_of(options_, number, view, std::nullopt));
    return distribution_ && !path.empty() && access(path.c_str(), F_OK) == 0 &&
           partial_fingerprint(path) == fingerprint_of(view, previous);
}

std::optional<Recovery> PictureSession::find_own(int number, const View& view,
                                                 const std::optional<View>& previous) const {
    if (!distribution_) return std::nullopt;
    const RpictOptions options = options_of(options_, number, view, std::nullopt);
    const std::string path = place_to_keep(options);
    if (path.empty() || access(path.c_str(), F_OK) != 0) return std::nullopt;
    if (!has_own(number, view, previous))
        throw Error(Location{path},
                    "it is an unfinished picture of another command, view or scene, which this one may not "
                    "go on with",
                    "remove it to begin anew, or finish it with -ro");
    return find_unfinished(options.output, options, loaded_.scene->channels(), warn_);
}

void PictureSession::render(int number, const View& view, const std::optional<View>& previous,
                            std::optional<Recovery> recovery) {
    const CompiledScene& scene = *loaded_.scene;
    Camera camera =
        camera_of(options_, recovery && recovery->view_found ? recovery->partial.view : view, previous);
    const RpictOptions options = options_of(options_, number, camera.view, recovery);
    PartialFrame partial = recovery ? std::move(recovery->partial) : PartialFrame{};
    partial.view = camera.view;
    partial.width = options.width;
    partial.height = options.height;
    partial.pixel_aspect = options.pixel_aspect;
    partial.fingerprint = fingerprint_of(camera.view, previous);
    if (partial.frame.traced.empty()) {
        std::vector<float> depths_found = std::move(partial.frame.depth);
        partial.frame = empty_frame(options.width, options.height, !options.depth_output.empty(),
                                    !options.error_output.empty(), scene.channels());
        if (!depths_found.empty()) partial.frame.depth = std::move(depths_found);
    }
    const FrameOptions size =
        frame_options(options_, options.width, options.height, partial.finished_rows.height, cache_);
    const std::vector<SmallSource> small_sources = pass_small_sources(scene, options_, size, camera);
    std::vector<std::string> lines = header_lines(loaded_.header, command_line_);
    Checkpoint checkpoint(place_to_keep(options), partial, lines, options_.checkpoint_seconds, warn_);
    if (number > 0 && options.report_seconds > 0)
        std::fprintf(stderr, "FRAME %d:%s\n", number, format_view(camera.view).c_str());
    const int rows = size.height - size.first_row;
    Progress progress(program_, static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(rows),
                      options.report_seconds);
    try {
        if (distribution_)
            distribution_->leader.render(scene, options.render.settings, camera, size, workers_, progress,
                                         partial.frame, checkpoint, report_);
        else
            render_frame(scene, options.render.settings, camera, size, workers_, progress, partial.frame,
                         &checkpoint, report_);
        throw_if_interrupted();
    } catch (const Error&) {
        if (!interrupted()) throw;
        keep(options, partial, lines, number);
    }
    progress.finish();
    if (!small_sources.empty()) {
        Tracer tracer(scene, options.render.settings, options.render.settings.seed);
        tracer.use_irradiance_cache(cache_);
        paint_small_sources(small_sources, camera.view, tracer, size.first_row, partial.frame);
        report_.add(tracer);
    }
    if (cache_) cache_->flush();

    if (number > 0) lines.push_back(formatted("FRAME=%d", number));
    write_frame(std::move(partial.frame), partial.finished_rows, scene, options, lines, command_line_);
    // What an unfinished picture held is in the whole one.
    if (recovery && !is_output(recovery->path, options.output)) std::remove(recovery->path.c_str());
    if (!options.output.empty() && can_be_resumed(options.output))
        std::remove(partial_name(options.output).c_str());
}

void PictureSession::keep(const RpictOptions& options, const PartialFrame& partial,
                          const std::vector<std::string>& lines, int number) const {
    ending_in_order();
    if (cache_) cache_->flush();
    std::string hint;
    if (const std::string path = place_to_keep(options); !path.empty()) {
        write_partial(path, partial, lines);
        const std::string which = number > 0 ? formatted("-r %d", number) : "-ro \"" + options.output + "\"";
        hint = std::string("the same command ") + (distribution_ ? "" : "with " + which + " ") +
               "goes on from \"" + path + "\"";
    } else if (options.output.empty() && number == 0 && is_plain_file(fileno(stdout))) {
        // Among other pictures of a sequence it could not be found again.
        write_partial(stdout, partial, lines);
        hint = "the same command with -ro FILE finishes the file that its output went to";
    }
    throw Error("interrupted", hint, Severity::internal);
}

}  // namespace infra
