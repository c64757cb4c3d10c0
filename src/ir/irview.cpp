// irview: a radiance picture as figures, as false colours with a legend, and as apparent temperatures.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "common/error.h"
#include "common/false_color.h"
#include "common/picture.h"
#include "common/version.h"
#include "ir/apparent_temperature.h"
#include "ir/irview_arguments.h"
#include "ir/plane.h"
#include "ir/region.h"
#include "ir/region_marks.h"

namespace infra::ir {
namespace {

bool is_exr(const std::string& path) { return path.ends_with(".exr"); }

/// The scale asked for, or that of the band that the picture names.
RadianceScale radiance_scale(const IrviewArguments& arguments, const PictureHeader& header) {
    if (arguments.scale) return *arguments.scale;
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
Picture shown_values(const Picture& picture, const IrviewArguments& arguments) {
    if (!arguments.temperature) return picture;
    const RadianceScale scale = radiance_scale(arguments, picture.header);
    return apparent_temperature(picture, scale, *arguments.temperature);
}

/// One channel: that asked for, or the mean of all. The mean is taken of radiances, before temperatures.
Picture single_channel(const Picture& picture, int channel) {
    Plane plane = plane_of(picture, channel);
    return {plane.width, plane.height, 1, ColorSpace::spectrum, std::move(plane.values), picture.header};
}

void print_statistics(const Picture& shown, const IrviewArguments& arguments) {
    std::vector<Region> regions = arguments.regions;
    if (regions.empty()) regions.push_back({0, 0, shown.width, shown.height, "all"});
    std::vector<std::vector<Statistics>> statistics;  // all before the first is printed
    for (const Region& region : regions) statistics.push_back(region_statistics(shown, region));
    if (arguments.temperature)
        std::printf("# apparent temperature, %s, %s\n", unit_name(*arguments.temperature).c_str(),
                    shown.header.value("BAND").value_or("").c_str());
    std::printf("# region\tchannel\tpixels\tmean\tdeviation\tminimum\tmaximum\n");
    for (std::size_t r = 0; r < regions.size(); ++r) {
        for (std::size_t c = 0; c < statistics[r].size(); ++c) {
            const Statistics& s = statistics[r][c];
            std::printf("%s\t%zu\t%zu\t%.9g\t%.9g\t%.9g\t%.9g\n", regions[r].label.c_str(), c, s.count,
                        s.mean, s.deviation, s.minimum, s.maximum);
        }
    }
}

void warn_of_missing(const Picture& shown) {
    std::size_t missing = 0, first = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i)
        if (!std::isfinite(shown.pixels[i]) && missing++ == 0) first = i;
    if (missing > 0)
        std::fprintf(stderr, "irview: warning: %zu pixels have no temperature, the first is %zu %zu\n",
                     missing, first % shown.width, first / shown.width);
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
        mark_region(image, region, region_statistics(shown, region)[0].mean,
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
    if (arguments.temperature) warn_of_missing(shown);
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
    Picture picture = read_picture(arguments->picture);
    undo_exposure(picture);
    if (arguments->block > 1) picture = block_mean(picture, arguments->block);
    for (const Region& region : arguments->regions) check_region(picture, region);

    if (arguments->print_statistics) print_statistics(shown_values(picture, *arguments), *arguments);
    if (!arguments->outputs.empty())
        write_outputs(shown_values(single_channel(picture, arguments->channel), *arguments), *arguments);
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("irview", infra::ir::run, argc, argv); }
