// Options of every subject: the band, the frame, the output; and those of atmosphere codes' files.
#include <algorithm>

#include "common/format.h"
#include "common/parse_number.h"
#include "ir/genirsky/option_values.h"
#include "ir/genirsky/options.h"

namespace infra::ir {
namespace {

void set_passband(Request& request, const OptionValues& given, Passband passband) {
    if (!request.passbands.empty())
        given.reject("there is a band or response already", "give -b or -r, once");
    request.passbands.push_back(std::move(passband));
}

/// "lambda,uu" as its words.
std::vector<std::string> split_list(std::string text) {
    std::ranges::replace(text, ',', ' ');
    return split_words(text);
}

}  // namespace

std::vector<double> number_list(const OptionValues& given) {
    std::vector<double> numbers;
    for (const std::string& word : split_list(given.text(0))) {
        double value = 0;
        if (!parse_real(word, value)) given.reject("\"" + word + "\" is not a number", "as in 0,30,60,85");
        numbers.push_back(value);
    }
    if (numbers.empty()) given.reject("expected numbers", "as in 0,30,60,85");
    return numbers;
}

double kelvin(const OptionValues& given, std::size_t n) {
    const double temperature = given.real(n);
    if (!(temperature > 0 && temperature <= hottest_temperature))
        given.reject(formatted("the temperature must be above 0 and at most %g K", hottest_temperature));
    return temperature;
}

void choose_source(Request& request, const OptionValues& given, Source source) {
    const bool repeatable = source == Source::tape7 || source == Source::uvspec;
    if (request.source != Source::none && !(repeatable && request.source == source))
        given.reject("the source is given by " + request.source_option + " already");
    request.source = source;
    request.source_option = given.option;
}

void add_band_options(OptionTable& table, Request& request) {
    table
        .custom(
            "-b", "ff",
            [&request](const OptionValues& given) {
                set_passband(request, given, Passband::of_band(given.real(0), given.real(1)));
            },
            "band in um, within 0.2..1000")
        .named("lo hi");
    table
        .custom(
            "-r", "s",
            [&request](const OptionValues& given) {
                set_passband(request, given, Passband::of_response(SpectralResponse::read(given.text(0))));
            },
            "spectral response: lines of a wavelength in um and a weight")
        .named("response.txt");
    table
        .custom(
            "-cs", "i", [&request](const OptionValues& given) { request.channel_count = given.integer(0); },
            "number of channels, with -cw: 3..6, 8, 12 or 24")
        .named("N");
    table
        .custom(
            "-cw", "ff",
            [&request](const OptionValues& given) {
                request.channel_range = {given.real(0), given.real(1)};
            },
            "range of wavelengths of the channels, nm")
        .named("nmA nmB");
}

void add_output_options(OptionTable& table, Request& request) {
    table.custom(
        "-yup", "", [&request](const OptionValues&) { request.frame.y_up = true; },
        "y points up; otherwise z");
    table.real(
        "-turn", &request.frame.turn_deg,
        "azimuth 0 turned from +x, counter-clockwise from above, degrees; 90 with azimuths of a compass");
    table.text("-id", &request.name, "name of the source; beginning of the other names").named("name");
    table.text("-o", &request.output, "file to write, otherwise the standard output").named("file");
}

void add_tape7_option(OptionTable& table, Request& request) {
    table
        .custom(
            "-tape7", "s",
            [&request](const OptionValues& given) {
                choose_source(request, given, Source::tape7);
                request.files.push_back(given.text(0));
            },
            "MODTRAN's tape7, with one run or several; may be given again")
        .named("file");
}

void add_uvspec_options(OptionTable& table, Request& request) {
    table
        .custom(
            "-uvspec", "s",
            [&request](const OptionValues& given) {
                choose_source(request, given, Source::uvspec);
                request.files.push_back(given.text(0));
            },
            "output of libRadtran's uvspec; may be given again")
        .named("file");
    table
        .custom(
            "-unit", "s",
            [&request](const OptionValues& given) {
                request.uvspec.unit = SpectralUnit::parse(given.text(0));
            },
            "of uvspec's radiances: " + SpectralUnit::choices())
        .named("unit");
    table
        .custom(
            "-columns", "s",
            [&request](const OptionValues& given) { request.uvspec.columns = split_list(given.text(0)); },
            "columns that output_user wrote; without it blocks of wavelengths")
        .named("lambda,uu");
}

}  // namespace infra::ir
