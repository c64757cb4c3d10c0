#include "ir/planck/arguments.h"

#include "common/error.h"
#include "common/options.h"
#include "common/parse_number.h"

namespace infra::ir {
namespace {

constexpr const char* description =
    "Radiance of a black surface from its temperature: W.m-2.sr-1 in a band of wavelengths, or weighted by\n"
    "a detector's spectral response; the way back; and the slope dL/dT. Values are given after the options\n"
    "or, without any, in a column of the standard input, whose other columns, empty lines and lines that\n"
    "begin with '#' pass unchanged. Temperatures are in kelvin unless -C is given. One result a line.\n"
    "\n"
    "  planck -b 8 12 300            the radiance of 300 K in 8..12 um, 38.5004239\n"
    "  planck -b 8 12 -i -C 31.4780  the temperature with that radiance, 15.0000 degrees C\n"
    "  planck -r lwir.txt -c 3 < facets.txt > radiances.txt";

void set_scale(PlanckArguments& arguments, const OptionValues& given, const RadianceScale& scale) {
    if (arguments.scale) given.reject("there is a band or response already", "give -b or -r, once");
    arguments.scale = scale;
}

void set_direction(PlanckArguments& arguments, const OptionValues& given, Direction direction) {
    if (arguments.direction != Direction::radiance && arguments.direction != direction)
        given.reject("-i and -d exclude one another");
    arguments.direction = direction;
}

void add_options(OptionTable& table, PlanckArguments& arguments, bool& column_given) {
    table.describe(description);
    table
        .custom(
            "-b", "ff",
            [&arguments](const OptionValues& given) {
                set_scale(arguments, given, RadianceScale::of_band(given.real(0), given.real(1)));
            },
            "band in um, within 0.2..1000")
        .named("lo hi");
    table
        .custom(
            "-r", "s",
            [&arguments](const OptionValues& given) {
                set_scale(arguments, given,
                          RadianceScale::of_response(SpectralResponse::read(given.text(0))));
            },
            "spectral response: lines of a wavelength in um and a weight")
        .named("response.txt");
    table.custom(
        "-i", "",
        [&arguments](const OptionValues& given) { set_direction(arguments, given, Direction::temperature); },
        "inverse: temperature from radiance");
    table.custom(
        "-d", "",
        [&arguments](const OptionValues& given) { set_direction(arguments, given, Direction::slope); },
        "slope dL/dT at the temperature, W.m-2.sr-1.K-1");
    table.custom(
        "-C", "", [&arguments](const OptionValues&) { arguments.celsius = true; },
        "temperatures in and out are in degrees Celsius");
    table
        .custom(
            "-c", "i",
            [&arguments, &column_given](const OptionValues& given) {
                arguments.column = given.integer(0);
                column_given = true;
            },
            "column of the standard input to convert, from 1 [-c 1]")
        .named("column")
        .at_least(1);
}

}  // namespace

std::optional<PlanckArguments> read_planck_arguments(int argc, char** argv) {
    PlanckArguments arguments;
    bool column_given = false;
    OptionTable table("planck", "[value ...]");
    add_options(table, arguments, column_given);
    const auto operands = table.parse(argc, argv);
    if (!operands) return std::nullopt;
    if (!arguments.scale) throw Error("no band", "-b 8 12 gives one in um, -r file a spectral response");
    for (const std::string& word : *operands) {
        double value = 0;
        if (!parse_real(word, value))
            throw Error("\"" + word + "\" is not a number", "values come after the options");
        arguments.values.push_back(value);
    }
    if (column_given && !arguments.values.empty())
        throw Error("-c is for the standard input", "leave out -c or the values");
    return arguments;
}

}  // namespace infra::ir
