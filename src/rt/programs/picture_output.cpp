#include "rt/programs/picture_output.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>
#include <utility>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "common/pictures/spectral_header.h"
#include "common/version.h"
#include "rt/programs/frame_name.h"
#include "rt/programs/value_converter.h"
#include "rt/split/split.h"

namespace infra {
namespace {

using Kind = OutputColor::Kind;

/// RADIANCE's standard primaries, which tell other programs that the channels are its RGB.
constexpr const char* standard_primaries =
    "PRIMARIES= 0.6400 0.3300 0.2900 0.6000 0.1500 0.0600 0.3333 0.3333";

bool has_ending(const std::string& path, const std::string& lower, const std::string& upper) {
    return path.ends_with(lower) || path.ends_with(upper);
}
bool is_exr(const std::string& path) { return has_ending(path, ".exr", ".EXR"); }
bool is_hsr(const std::string& path) { return has_ending(path, ".hsr", ".HSR"); }

/// Pixel by pixel what the converter makes of the radiances.
Picture converted(const Picture& picture, const OutputColor& color, const Channels& channels) {
    const ValueConverter converter(color, channels);
    Picture result{.width = picture.width, .height = picture.height, .channels = converter.components()};
    result.space = color.kind == Kind::xyz ? ColorSpace::xyz : ColorSpace::rgb;
    result.pixels.reserve(picture.pixels.size() / picture.channels * result.channels);
    Spectrum radiance(picture.channels);
    for (std::size_t first = 0; first < picture.pixels.size(); first += picture.channels) {
        for (int c = 0; c < picture.channels; ++c) radiance.set(c, picture.pixels[first + c]);
        const ValueConverter::Numbers numbers = converter.radiance(radiance);
        result.pixels.insert(result.pixels.end(), numbers.values.begin(),
                             numbers.values.begin() + numbers.count);
    }
    return result;
}

/// The picture with the channels that are to be written. RGB in other primaries passes as it is: whoever
/// gives -pc to RGB channels says what the scene's colors are.
Picture in_output_channels(Picture picture, const RpictOptions& options, const Channels& channels) {
    const bool as_they_are = channels.is_rgb() && options.color.kind != Kind::xyz;
    if (writes_colors(options) && !as_they_are) return converted(picture, options.color, channels);
    if (!channels.is_rgb()) picture.bands = channels;
    return picture;
}

PictureHeader picture_header(const std::vector<std::string>& first_lines, const RpictOptions& options,
                             const Picture& picture, const CompiledScene& scene) {
    PictureHeader header;
    header.lines = first_lines;
    header.add("VIEW=" + format_view(options.view));
    if (options.pixel_aspect < 0.995 || options.pixel_aspect > 1.005)
        header.add(formatted("PIXASPECT=%f", options.pixel_aspect));
    if (options.color.kind == Kind::primaries && !picture.bands) {
        for (const std::string& line : color_header_lines(options.color, scene.channels().one_component()))
            header.add(line);
    } else if (picture.space == ColorSpace::rgb) {
        header.add(standard_primaries);
    }
    // Bands of spectral channels stand in lines of their own.
    if (const auto& band = scene.band(); band && !picture.bands)
        header.add(formatted("BAND= %g-%g um", band->first, band->second));
    return header;
}

ExrDescription describe(const RpictOptions& options, const Picture& picture,
                        const std::string& command_line) {
    const bool irradiance = options.render.settings.irradiance;
    ExrDescription description{.program = command_line,
                               .view = format_view(options.view),
                               .quantity = irradiance ? "irradiance" : "radiance",
                               .unit = irradiance ? "W.m-2" : "W.m-2.sr-1",
                               .band = {},
                               .software = version_string()};
    if (picture.space == ColorSpace::xyz) {
        description.quantity = "tristimulus values";
        description.unit.clear();
    }
    description.band = picture.bands ? band_in_um(*picture.bands) : picture.header.value("BAND").value_or("");
    return description;
}

/// Standard errors as a picture of the scene's channels.
void write_error(const std::string& path, const Picture& values, std::vector<float> errors,
                 ExrDescription description) {
    Picture picture{.width = values.width, .height = values.height, .channels = values.channels};
    picture.space = values.space;
    picture.header = values.header;
    picture.bands = values.bands;
    picture.pixels = std::move(errors);
    description.quantity = "standard error of " + description.quantity;
    write_exr(path, picture, description);
}

/// The radiance of pixels that are kept in components.
Picture summed(const Frame& frame) {
    Picture picture{.width = frame.picture.width, .height = frame.picture.height, .channels = frame.bands()};
    picture.space = frame.picture.space;
    const std::size_t all = frame.picture.channels;
    picture.pixels.reserve(frame.picture.pixels.size() / frame.components);
    for (std::size_t first = 0; first < frame.picture.pixels.size(); first += all)
        for (int band = 0; band < frame.bands(); ++band)
            picture.pixels.push_back(frame.total(std::span(frame.picture.pixels).subspan(first, all), band));
    return picture;
}

/// The radiance in the scene's own channels, and its components as layers.
void write_split(Picture radiance, const Frame& frame, const CompiledScene& scene,
                 const RpictOptions& options, const std::vector<std::string>& first_lines,
                 const std::string& command_line) {
    if (!scene.channels().is_rgb()) radiance.bands = scene.channels().one_component();
    radiance.header = picture_header(first_lines, options, radiance, scene);
    const ExrLayers layers{component_names(*options.render.settings.split), frame.picture.pixels};
    write_exr(options.split_output, radiance, describe(options, radiance, command_line), &layers);
}

void write_depth(const std::string& path, const std::vector<float>& depth) {
    AtomicFile file(path);
    std::fwrite(depth.data(), sizeof(float), depth.size(), file.stream());
    file.commit();
}

/// A name that promises another format is a slip.
void refuse_foreign(const std::string& path) {
    for (const char* ending : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".pfm", ".ppm", ".bmp", ".gif"}) {
        const std::string_view suffix(ending);
        if (path.size() < suffix.size()) continue;
        const auto last = path.end() - static_cast<std::ptrdiff_t>(suffix.size());
        if (std::equal(last, path.end(), suffix.begin(),
                       [](unsigned char a, char b) { return std::tolower(a) == b; }))
            throw Error(Location{path}, "rpict writes .hdr, .hsr and .exr", "irview makes PNG of them");
    }
}

/// Pipes and devices are left alone: opening them has consequences.
void check_writable(const std::string& path) {
    struct stat status {};
    const bool exists = stat(path.c_str(), &status) == 0;
    if (!path.empty() && (!exists || S_ISREG(status.st_mode))) AtomicFile probe(path);
}

}  // namespace

bool writes_colors(const RpictOptions& options) {
    if (options.color.kind == Kind::spectrum || is_hsr(options.output)) return false;
    return !is_exr(options.output) || options.color.kind != Kind::rgb;
}

void check_writable(const RpictOptions& options) {
    refuse_foreign(options.output);
    if (options.is_sequence()) return;  // others may be at work on it
    check_writable(frame_name(options.output, 0));
    check_writable(frame_name(options.depth_output, 0));
    check_writable(frame_name(options.error_output, 0));
    check_writable(frame_name(options.split_output, 0));
}

void write_frame(Frame frame, const Picture& finished_rows, const CompiledScene& scene,
                 const RpictOptions& options, const std::vector<std::string>& first_lines,
                 const std::string& command_line) {
    Picture radiance = frame.components > 1 ? summed(frame) : std::move(frame.picture);
    if (frame.components > 1) write_split(radiance, frame, scene, options, first_lines, command_line);
    Picture picture = in_output_channels(std::move(radiance), options, scene.channels().one_component());
    if (finished_rows.height > 0) {
        if (finished_rows.channels != picture.channels)
            throw Error("recovered scanlines have other channels", {}, Severity::internal);
        std::ranges::copy(finished_rows.pixels, picture.pixels.begin());
    }
    picture.header = picture_header(first_lines, options, picture, scene);
    if (!options.depth_output.empty()) write_depth(options.depth_output, frame.depth);
    if (!options.error_output.empty())
        write_error(options.error_output, picture, std::move(frame.error),
                    describe(options, picture, command_line));
    if (is_exr(options.output)) {
        write_exr(options.output, picture, describe(options, picture, command_line));
    } else if (!options.output.empty()) {
        write_hdr(options.output, picture);
    } else {
        write_hdr(stdout, picture);  // and flushes it
    }
}

}  // namespace infra
