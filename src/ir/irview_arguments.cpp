#include "ir/irview_arguments.h"

#include "common/error.h"
#include "common/options.h"

namespace infra::ir {
namespace {

constexpr const char* description =
    "A picture of radiances as figures, as false colours with a legend, as apparent temperatures.\n"
    "\n"
    "  irview -o hull.png -s 30 38 hull.exr\n"
    "  irview -C -band 8 12 -palette white-hot -o hull.png -o temperature.exr hull.exr\n"
    "  irview -K -band 8 12 -stats -region 40 10 80 30 funnel hull.exr";

void add_output_options(OptionTable& table, IrviewArguments& arguments) {
    table
        .custom(
            "-o", "s",
            [&arguments](const OptionValues& given) { arguments.outputs.push_back(given.text(0)); },
            "file to write, PNG or float OpenEXR (.exr) of the values shown; may be given again")
        .named("picture");
    table
        .custom(
            "-s", "ff",
            [&arguments](const OptionValues& given) {
                if (!(given.real(1) > given.real(0))) given.reject("low must be less than high");
                arguments.range = {given.real(0), given.real(1)};
            },
            "ends of the colour scale; without it those of the picture")
        .named("low high");
    table
        .custom(
            "-palette", "s",
            [&arguments](const OptionValues& given) { arguments.palette = find_palette(given.text(0)); },
            "inferno (default), magma, viridis, gray, white-hot or black-hot")
        .named("name");
    table
        .custom(
            "-l", "s", [&arguments](const OptionValues& given) { arguments.label = given.text(0); },
            "title of the legend")
        .named("label");
    table
        .custom(
            "-u", "s", [&arguments](const OptionValues& given) { arguments.unit = given.text(0); },
            "unit under the title")
        .named("unit");
}

void set_scale(IrviewArguments& arguments, const OptionValues& given, const RadianceScale& scale) {
    if (arguments.scale) given.reject("there is a band or response already");
    arguments.scale = scale;
}

void set_temperature(IrviewArguments& arguments, const OptionValues& given, TemperatureUnit unit) {
    if (arguments.temperature && arguments.temperature != unit) given.reject("-K and -C exclude one another");
    arguments.temperature = unit;
}

void add_temperature_options(OptionTable& table, IrviewArguments& arguments) {
    table.custom(
        "-K", "",
        [&arguments](const OptionValues& given) {
            set_temperature(arguments, given, TemperatureUnit::kelvin);
        },
        "show apparent temperature in kelvin");
    table.custom(
        "-C", "",
        [&arguments](const OptionValues& given) {
            set_temperature(arguments, given, TemperatureUnit::celsius);
        },
        "show apparent temperature in degrees Celsius");
    table
        .custom(
            "-band", "ff",
            [&arguments](const OptionValues& given) {
                set_scale(arguments, given, RadianceScale::of_band(given.real(0), given.real(1)));
            },
            "band of the radiances in um, not of single channels; without it the one that the picture names")
        .named("lo hi");
    table
        .custom(
            "-response", "s",
            [&arguments](const OptionValues& given) {
                set_scale(arguments, given,
                          RadianceScale::of_response(SpectralResponse::read(given.text(0))));
            },
            "spectral response instead: lines of a wavelength in um and a weight")
        .named("file");
}

void add_picture_options(OptionTable& table, IrviewArguments& arguments) {
    table
        .custom(
            "-c", "i", [&arguments](const OptionValues& given) { arguments.channel = given.integer(0); },
            "channel to show, from 0; without it the mean of all")
        .named("channel")
        .at_least(0);
    table
        .text("-layer", &arguments.layer,
              "layer of an OpenEXR picture, such as a component of rpict's -split")
        .named("name");
    table
        .custom(
            "-wl", "f", [&arguments](const OptionValues& given) { arguments.wavelength_um = given.real(0); },
            "channel of a spectral picture that holds this wavelength in um")
        .named("wavelength");
    table
        .custom(
            "-b", "i", [&arguments](const OptionValues& given) { arguments.block = given.integer(0); },
            "average the radiances of blocks of that many pixels a side first")
        .named("pixels")
        .at_least(1);
    table
        .custom(
            "-region", "iiiis",
            [&arguments](const OptionValues& given) {
                arguments.regions.push_back(
                    {given.integer(0), given.integer(1), given.integer(2), given.integer(3), given.text(4)});
            },
            "rectangle to mark and measure, x1 and y1 excluded, from the upper left")
        .named("x0 y0 x1 y1 label");
    table.custom(
        "-stats", "", [&arguments](const OptionValues&) { arguments.print_statistics = true; },
        "print mean, deviation, extremes of the regions, or of the whole picture");
}

}  // namespace

std::optional<IrviewArguments> read_irview_arguments(int argc, char** argv) {
    IrviewArguments arguments;
    OptionTable table("irview", "picture");
    table.describe(description);
    add_output_options(table, arguments);
    add_temperature_options(table, arguments);
    add_picture_options(table, arguments);
    const auto operands = table.parse(argc, argv);
    if (!operands) return std::nullopt;
    if (operands->size() != 1) throw Error("give one picture", "irview [options] picture");
    if (arguments.outputs.empty() && !arguments.print_statistics)
        throw Error("nothing to do", "-o picture.png writes a false-colour picture, -stats prints figures");
    if (arguments.wavelength_um && arguments.channel >= 0)
        throw Error("-c and -wl both choose a channel", "give one of them");
    if (arguments.scale && !arguments.temperature)
        throw Error("a band or response is for apparent temperatures", "-K or -C asks for them");
    arguments.picture = operands->front();
    arguments.command_line = table.command_line() + " " + arguments.picture;
    return arguments;
}

}  // namespace infra::ir
