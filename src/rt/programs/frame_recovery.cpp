#include "rt/programs/frame_recovery.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "common/error.h"
#include "rt/programs/picture_output.h"

namespace infra {
namespace {

std::optional<off_t> file_size(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return status.st_size;
}

/// What the pixels of the picture to be are.
ColorSpace output_space(const RpictOptions& options) {
    if (!writes_colors(options)) return ColorSpace::spectrum;
    return options.color.kind == OutputColor::Kind::xyz ? ColorSpace::xyz : ColorSpace::rgb;
}

/// Rows that another program or run has finished go into the picture as they are.
void require_same_kind(const std::string& path, const Picture& rows, const RpictOptions& options,
                       const Channels& channels) {
    const ColorSpace space = channels.is_rgb() && output_space(options) == ColorSpace::spectrum
                                 ? ColorSpace::rgb
                                 : output_space(options);
    const int count = space == ColorSpace::spectrum ? channels.count() : 3;
    if (rows.space != space || rows.channels != count)
        throw Error(Location{path}, "its pixels are of another kind than those to be written",
                    "finish it with the options it was begun with");
}

/// Distances of the rows that are taken over.
void read_depths(const std::string& path, std::size_t count, std::vector<float>& depth,
                 const WarningSink& warn) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    const std::size_t found = file ? std::fread(depth.data(), sizeof(float), count, file.get()) : 0;
    if (found < count) warn("\"" + path + "\" lacks distances of recovered scanlines, which are 0 therefore");
}

/// Complete scanlines of a picture in RADIANCE's format.
Recovery recover_rows(const std::string& path, const RpictOptions& options, const Channels& channels,
                      const WarningSink& warn) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw Error("cannot read recover file \"" + path + "\"", {}, Severity::system);
    UnfinishedRows found = read_unfinished_hdr(file.get(), path);
    if (options.render.settings.split)
        throw Error(Location{path}, "the components of its pixels are not known", "leave -split out");
    require_same_kind(path, found.rows, options, channels);
    Recovery recovery;
    recovery.path = path;
    PartialFrame& partial = recovery.partial;
    if (const auto view = found.rows.header.view()) {
        partial.view = *view;
        recovery.view_found = true;
    } else {
        warn("cannot recover view parameters from \"" + path + "\"");
    }
    partial.width = found.rows.width;
    partial.height = found.height;
    partial.pixel_aspect = 0;  // follows from the view
    if (!options.error_output.empty() && partial.finished_rows.height > 0)
        throw Error(Location{path}, "the errors of its rows are not known",
                    "leave -se out, or render it anew");
    partial.finished_rows = std::move(found.rows);
    partial.frame = {};
    if (!options.depth_output.empty() && partial.finished_rows.height > 0) {
        partial.frame.depth.resize(std::size_t(partial.width) * partial.height);
        read_depths(options.depth_output, std::size_t(partial.width) * partial.finished_rows.height,
                    partial.frame.depth, warn);
    }
    return recovery;
}

Recovery recover_frame(const std::string& path, const RpictOptions& options, const Channels& channels) {
    Recovery recovery;
    recovery.path = path;
    recovery.view_found = true;
    recovery.partial = read_partial(path, channels);
    const PartialFrame& partial = recovery.partial;
    if (partial.finished_rows.height > 0) require_same_kind(path, partial.finished_rows, options, channels);
    const auto require_same = [&](const char* option, bool begun_with, bool wanted) {
        if (begun_with != wanted)
            throw Error(Location{path},
                        std::string("it was begun ") + (begun_with ? "with " : "without ") + option,
                        "finish it with the options it was begun with");
    };
    require_same("-z", !partial.frame.depth.empty(), !options.depth_output.empty());
    require_same("-se", !partial.frame.error.empty(), !options.error_output.empty());
    return recovery;
}

}  // namespace

std::optional<Recovery> find_unfinished(const std::string& path, const RpictOptions& options,
                                        const Channels& channels, const WarningSink& warn) {
    if (file_size(partial_name(path))) return recover_frame(partial_name(path), options, channels);
    const std::optional<off_t> size = file_size(path);
    if (!size) {
        warn(path == options.output ? "new output file \"" + path + "\""
                                    : "cannot open recover file \"" + path + "\"");
        return std::nullopt;
    }
    if (*size == 0 && options.is_sequence()) return std::nullopt;
    if (*size == 0)
        throw Error(Location{path}, "recover file is empty, so that not even its view is known",
                    "remove it and render anew");
    if (is_partial(path)) return recover_frame(path, options, channels);
    return recover_rows(path, options, channels, warn);
}

}  // namespace infra
