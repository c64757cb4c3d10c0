// irview: a radiance picture as figures and as a false-colour picture with a legend.
//
//     irview -o hull.png -s 30 38 hull.exr
//     irview -stats -region 40 10 80 30 funnel hull.exr
#include <cstdio>
#include <string>
#include <vector>

#include "common/error.h"
#include "common/false_color.h"
#include "common/options.h"
#include "common/picture.h"
#include "ir/plane.h"
#include "ir/region.h"
#include "ir/region_marks.h"

namespace infra::ir {
namespace {

struct Arguments {
    std::string output;
    FalseColorScale scale{.quantity = "radiance", .unit = "W.m-2.sr-1"};
    bool scale_given = false;
    int channel = -1;
    int block = 1;
    bool print_statistics = false;
    std::vector<Region> regions;
};

void describe_options(OptionTable& options, Arguments& arguments) {
    options.text("-o", &arguments.output, "PNG file to write").named("picture.png");
    options
        .custom(
            "-s", "ff",
            [&arguments](const OptionValues& given) {
                arguments.scale.low = given.real(0);
                arguments.scale.high = given.real(1);
                if (!(arguments.scale.high > arguments.scale.low)) given.reject("low must be less than high");
                arguments.scale_given = true;
            },
            "ends of the colour scale; without it those of the picture")
        .named("low high");
    options.text("-l", &arguments.scale.quantity, "title of the legend").named("label");
    options.text("-u", &arguments.scale.unit, "unit under the title").named("unit");
    options
        .custom(
            "-c", "i", [&arguments](const OptionValues& given) { arguments.channel = given.integer(0); },
            "channel to show, from 0; without it the mean of all")
        .named("channel")
        .at_least(0);
    options
        .custom(
            "-b", "i", [&arguments](const OptionValues& given) { arguments.block = given.integer(0); },
            "average blocks of that many pixels a side first")
        .named("pixels")
        .at_least(1);
    options
        .custom(
            "-region", "iiiis",
            [&arguments](const OptionValues& given) {
                arguments.regions.push_back(
                    {given.integer(0), given.integer(1), given.integer(2), given.integer(3), given.text(4)});
            },
            "rectangle to mark and measure, x1 and y1 excluded, from the upper left")
        .named("x0 y0 x1 y1 label");
    options.custom(
        "-stats", "", [&arguments](const OptionValues&) { arguments.print_statistics = true; },
        "print mean, deviation, extremes of the regions, or of the whole picture");
    const std::string later = "apparent temperatures are not built yet";
    options.unsupported("-K", "", later);
    options.unsupported("-C", "", later);
    options.unsupported("-band", "ff", later);
    options.unsupported("-palette", "s", "there is one palette so far");
}

void print_statistics(const Picture& picture, const std::vector<Region>& regions) {
    std::printf("# region\tchannel\tpixels\tmean\tdeviation\tminimum\tmaximum\n");
    for (const Region& region : regions) {
        const std::vector<Statistics> channels = region_statistics(picture, region);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const Statistics& s = channels[c];
            std::printf("%s\t%zu\t%zu\t%.9g\t%.9g\t%.9g\t%.9g\n", region.label.c_str(), c, s.count, s.mean,
                        s.deviation, s.minimum, s.maximum);
        }
    }
}

void write_false_color(const Picture& picture, Arguments arguments) {
    const Plane plane = plane_of(picture, arguments.channel);
    if (!arguments.scale_given) {
        const Range range = finite_range(plane.values);
        arguments.scale.low = range.low;
        arguments.scale.high = range.high > range.low ? range.high : range.low + 1;
    }
    Image8 image = false_color_with_legend(plane.values, plane.width, plane.height, arguments.scale);
    const Picture single{plane.width, plane.height, 1, ColorSpace::spectrum, plane.values, {}};
    for (const Region& region : arguments.regions)
        mark_region(image, region, region_statistics(single, region)[0].mean,
                    (image.height - plane.height) / 2);
    write_png(arguments.output, image);
}

int run(int argc, char** argv) {
    Arguments arguments;
    OptionTable options("irview", "picture");
    describe_options(options, arguments);
    const auto operands = options.parse(argc, argv);
    if (!operands) return 0;
    if (operands->size() != 1) throw Error("give one picture", "irview [options] picture");
    if (arguments.output.empty() && !arguments.print_statistics)
        throw Error("nothing to do", "-o picture.png writes a false-colour picture, -stats prints figures");

    Picture picture = read_picture(operands->front());
    undo_exposure(picture);
    if (arguments.block > 1) picture = block_mean(picture, arguments.block);
    for (const Region& region : arguments.regions) check_region(picture, region);

    if (arguments.print_statistics) {
        const Region whole{0, 0, picture.width, picture.height, "all"};
        print_statistics(picture, arguments.regions.empty() ? std::vector{whole} : arguments.regions);
    }
    if (!arguments.output.empty()) write_false_color(picture, arguments);
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("irview", infra::ir::run, argc, argv); }
