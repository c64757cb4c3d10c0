// irview: a radiance picture as figures, as false colours with a legend, and as apparent temperatures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "common/error.h"
#include "common/format.h"
#include "common/pictures/false_color.h"
#include "common/pictures/picture.h"
#include "common/version.h"
#include "ir/apparent_temperature.h"
#include "ir/irview_arguments.h"
#include "ir/plane.h"
#include "ir/region.h"
#include "ir/region_marks.h"

namespace infra::ir {
namespace {

bool is_exr(const std::string& path) { return path.ends_with(".exr"); }

/// The scale asked for, or that of the band that the picture names. A channel of a spectral picture has its
/// own band: what is asked for is the whole range's.
RadianceScale radiance_scale(const IrviewArguments& arguments, const PictureHeader& header, bool own_band) {
    if (arguments.scale && !own_band) return *arguments.scale;
    const std::string hint = "-band 8 12 gives it in um, -response file a spectral response";
    const auto band = header.value("BAND");
    if (!band) throw Error(Location{arguments.picture}, "the picture names no band", hint);
    try {
        return RadianceScale::parse(*band);
    } catch (const Error& error) {
        throw Error(Location{arguments.picture}, "the picture's band: " + error.message(), hint);
    }
}

/// The values to show: those of the picture, or the temperatures wanted.
///   own_band  it is a channel of a spectral picture
Picture shown_values(const Picture& picture, const IrviewArguments& arguments, bool own_band = false) {
    if (!arguments.temperature) return picture;
    const RadianceScale scale = radiance_scale(arguments, picture.header, own_band);
    return apparent_temperature(picture, scale, *arguments.temperature);
}

/// One channel: that asked for, or the mean of all. The mean is taken of radiances, before temperatures. Of a
/// spectral picture the radiance in the channel's band, or in the whole range.
Picture single_channel(const Picture& picture, int channel) {
    if (picture.bands) return in_band_radiance(picture, channel);
    Plane plane = plane_of(picture, channel);
    return {plane.width, plane.height, 1, ColorSpace::spectrum, std::move(plane.values), picture.header, {}};
}

/// Values that -stats prints, a line for each region and channel.
struct Measured {
    std::vector<std::string> names;  ///< of the channels
    Picture values;

    std::string band() const { return values.header.value("BAND").value_or(""); }
};

/// Every channel as it is; of a spectral picture the whole range and every channel in its own band, or the
/// one asked for.
std::vector<Measured> measured_values(const Picture& picture, const IrviewArguments& arguments, int channel) {
    std::vector<Measured> result;
    if (!picture.bands) {
        result.push_back({{}, shown_values(picture, arguments)});
        for (int c = 0; c < picture.channels; ++c) result[0].names.push_back(std::to_string(c));
        return result;
    }
    const int first = channel >= 0 ? channel : -1, last = channel >= 0 ? channel : picture.channels - 1;
    for (int c = first; c <= last; ++c)
        result.push_back({{c < 0 ? "all" : std::to_string(c)},
                          shown_values(in_band_radiance(picture, c), arguments, c >= 0)});
    return result;
}

std::string lack(const IrviewArguments& arguments) {
    return arguments.temperature ? "have no temperature" : "are not finite numbers";
}

/// throws Error that names file and region when none of its pixels has a value
std::vector<Statistics> measure(const Picture& values, const Region& region,
                                const IrviewArguments& arguments) {
    try {
        return region_statistics(values, region);
    } catch (const Error& error) {
        throw Error(Location{arguments.picture}, error.message(), error.hint());
    }
}

/// Says once of a region how many of its pixels the figures leave out, where some do.
void warn_of_left_out(const Region& region, std::size_t missing, const IrviewArguments& arguments) {
    if (missing == 0) return;
    const int pixels = (region.x1 - region.x0) * (region.y1 - region.y0);
    const std::string text =
        formatted("%s: region %s: %zu of %d pixels %s and are left out", arguments.picture.c_str(),
                  region.label.c_str(), missing, pixels, lack(arguments).c_str());
    std::fprintf(stderr, "irview: warning: %s\n", message_line(text).c_str());
}

void print_statistics(const Picture& picture, const IrviewArguments& arguments, int channel) {
    std::vector<Region> regions = arguments.regions;
    if (regions.empty()) regions.push_back({0, 0, picture.width, picture.height, "all"});
    const std::vector<Measured> measured = measured_values(picture, arguments, channel);
    std::string table;  // all before the first is printed
    for (const Region& region : regions) {
        std::size_t missing = 0;
        for (const Measured& part : measured) {
            const std::vector<Statistics> statistics = measure(part.values, region, arguments);
            for (std::size_t c = 0; c < statistics.size(); ++c) {
                const Statistics& s = statistics[c];
                missing = std::max(missing, s.missing);
                table += formatted("%s\t%s\t%zu\t%.9g\t%.9g\t%.9g\t%.9g\n", region.label.c_str(),
                                   part.names[c].c_str(), s.count, s.mean, s.deviation, s.minimum, s.maximum);
            }
        }
        warn_of_left_out(region, missing, arguments);
    }
    if (arguments.temperature)
        std::printf("# apparent temperature, %s, %s\n", unit_name(*arguments.temperature).c_str(),
                    measured[0].band().c_str());
    if (picture.bands)
        for (const Measured& part : measured)
            std::printf("# channel %s: %s\n", part.names[0].c_str(), part.band().c_str());
    std::printf("# region\tchannel\tpixels\tmean\tdeviation\tminimum\tmaximum\n%s", table.c_str());
}

void warn_of_missing(const Picture& shown, const IrviewArguments& arguments) {
    std::size_t missing = 0, first = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i)
        if (!std::isfinite(shown.pixels[i]) && missing++ == 0) first = i;
    if (missing == 0) return;
    const std::string text =
        formatted("%s: %zu pixels %s, the first is %zu %zu", arguments.picture.c_str(), missing,
                  lack(arguments).c_str(), first % shown.width, first / shown.width);
    std::fprintf(stderr, "irview: warning: %s\n", message_line(text).c_str());
}

Image8 false_color_image(const Picture& shown, const IrviewArguments& arguments) {
    const Range found = finite_range(shown.pixels);
    const auto [low, high] = arguments.range.value_or(
        std::pair<double, double>(found.low, found.high > found.low ? found.high : found.low + 1));
    const FalseColorScale scale{
        .low = low,
        .high = high,
        .quantity = arguments.label.value_or(shown.header.value("QUANTITY").value_or("radiance")),
        .unit = arguments.unit.value_or(shown.header.value("UNIT").value_or("W.m-2.sr-1")),
        .palette = arguments.palette};
    Image8 image = false_color_with_legend(shown.pixels, shown.width, shown.height, scale);
    for (const Region& region : arguments.regions)
        mark_region(image, region, measure(shown, region, arguments)[0].mean,
                    (image.height - shown.height) / 2);
    return image;
}

ExrDescription describe(const PictureHeader& header, const std::string& command_line) {
    return {.program = command_line,
            .view = header.value("VIEW").value_or(""),
            .quantity = header.value("QUANTITY").value_or("radiance"),
            .unit = header.value("UNIT").value_or("W.m-2.sr-1"),
            .band = header.value("BAND").value_or(""),
            .software = version_string()};
}

void write_outputs(const Picture& shown, const IrviewArguments& arguments) {
    if (arguments.temperature) warn_of_missing(shown, arguments);
    for (const std::string& path : arguments.outputs) {
        if (is_exr(path)) {
            write_exr(path, shown, describe(shown.header, arguments.command_line));
        } else {
            write_png(path, false_color_image(shown, arguments));
        }
    }
}

int run(int argc, char** argv) {
    const auto arguments = read_irview_arguments(argc, argv);
    if (!arguments) return 0;
    Picture picture = arguments->layer.empty() ? read_picture(arguments->picture)
                                               : read_exr_layer(arguments->picture, arguments->layer);
    undo_exposure(picture);
    if (arguments->block > 1) picture = block_mean(picture, arguments->block);
    for (const Region& region : arguments->regions) check_region(picture, region);

    const int channel =
        arguments->wavelength_um ? channel_at(picture, *arguments->wavelength_um) : arguments->channel;
    if (picture.bands && channel >= 0 && arguments->scale)
        throw Error("-band and -response are for the whole range of a spectral picture",
                    "a channel has its own band: leave them out");
    if (arguments->print_statistics) print_statistics(picture, *arguments, channel);
    if (!arguments->outputs.empty())
        write_outputs(shown_values(single_channel(picture, channel), *arguments), *arguments);
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("irview", infra::ir::run, argc, argv); }
