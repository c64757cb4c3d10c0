#include "ir/genirsky/request.h"

#include <algorithm>
#include <array>

#include "common/error.h"
#include "common/format.h"
#include "ir/genirsky/options.h"

namespace infra::ir {
namespace {

constexpr const char* purpose =
    "Skies, seas, the sun and the air between, for a band of the infrared, from tables, temperatures or an\n"
    "atmosphere code's files. Writes scene files of lib/skyfuncs, and files for the option -mp of rpict.\n"
    "\n"
    "  genirsky sky -elev sky.txt -K -b 8 12 -o sky.rad\n"
    "  genirsky sky -tape7 up.tp7 -angles 0,30,60,75,85 -b 8 12 -o sky.rad\n"
    "  genirsky sea -plane sea.txt -K -height 12 -b 8 12 -o sea.rad\n"
    "  genirsky sun -ang 35 120 -trans .8 -b 3 5 -o sun.rad\n"
    "  genirsky air -tape7 paths.tp7 -ranges 500,1000,4000 -b 8 12 -o path.air";

constexpr std::array<std::string_view, 4> subjects{"sky", "sea", "sun", "air"};

std::optional<Subject> find_subject(std::string_view word) {
    const auto found = std::ranges::find(subjects, word);
    if (found == subjects.end()) return std::nullopt;
    return static_cast<Subject>(found - subjects.begin());
}

Subject require_subject(const std::string& word) {
    const std::optional<Subject> subject = find_subject(word);
    if (!subject) {
        const std::string near = nearest_name(word, subjects);
        throw Error("\"" + word + "\" is none of sky, sea, sun and air",
                    near.empty() ? "genirsky sky -help lists the options of the sky"
                                 : "did you mean \"" + near + "\"?");
    }
    return *subject;
}

void describe_options(OptionTable& table, Request& request) {
    table.describe(purpose);
    switch (request.subject) {
        case Subject::sky:
            add_dome_options(table, request);
            break;
        case Subject::sea:
            add_dome_options(table, request);
            add_plane_options(table, request);
            break;
        case Subject::sun:
            add_sun_options(table, request);
            break;
        case Subject::air:
            add_air_options(table, request);
            break;
    }
    add_band_options(table, request);
    if (request.subject != Subject::air) add_output_options(table, request);
}

/// Bands of the channels that -cs and -cw ask for.
void make_channels(Request& request) {
    if (request.channel_count == 0 && !request.channel_range) return;
    if (request.channel_count == 0 || !request.channel_range)
        throw Error("-cs and -cw belong together", "-cs 8 -cw 8000 12000");
    if (!request.passbands.empty()) throw Error("-cs and -cw exclude -b and -r");
    const auto [nm_a, nm_b] = *request.channel_range;
    request.channels = Channels::spectral(request.channel_count, nm_a, nm_b);
    // specfunc calls a function at 24 wavelengths at most: these must not straddle channels
    if (request.channel_count > 6 && 24 % request.channel_count != 0)
        throw Error(formatted("%d channels", request.channel_count), "3..6, 8, 12 or 24");
    constexpr double nm = 1e-3;
    for (int c = 0; c < request.channel_count; ++c)
        request.passbands.push_back(
            Passband::of_band(nm * request.channels->lower_nm(c), nm * request.channels->upper_nm(c)));
}

/// An option that the source does not read is a slip.
void check_unread(const Request& request) {
    struct Row {
        bool given;
        std::string_view option;
        std::vector<Source> readers;
        std::string_view use;
    };
    const UvspecLayout& uvspec = request.uvspec;
    const Sensor& sensor = request.sensor;
    const std::vector<Source> columns =
        uvspec.columns.empty() ? std::vector<Source>{} : std::vector{Source::uvspec};
    const Row rows[] = {
        {request.from_horizon, "-from-horizon", {Source::elevations, Source::thrend}, "-elev or -thrend"},
        {!request.angles_deg.empty(), "-angles", {Source::tape7}, "-tape7"},
        {uvspec.unit.has_value(), "-unit", {Source::uvspec}, "-uvspec"},
        {!uvspec.columns.empty(), "-columns", {Source::uvspec}, "-uvspec"},
        {!uvspec.umu.empty(), "-umu", columns, "-uvspec with -columns"},
        {!uvspec.phi.empty(), "-phi", columns, "-uvspec with -columns"},
        {sensor.height != 0, "-height", {Source::plane}, "-plane"},
        {sensor.x != 0 || sensor.y != 0, "-at", {Source::plane}, "-plane"},
        {request.horizon.has_value(), "-horizon", {Source::plane}, "-plane"}};
    for (const Row& row : rows)
        if (row.given && std::ranges::count(row.readers, request.source) == 0)
            throw Error(std::string(row.option) + " is not read here", std::string(row.use) + " does");
}

void check_dome(const Request& request) {
    switch (request.source) {
        case Source::none:
            throw Error("nothing to make it from", request.subject == Subject::sky
                                                       ? "-elev, -table, -thrend, -tape7 or -uvspec"
                                                       : "-elev, -table, -plane, -tape7 or -uvspec");
        case Source::tape7:
            if (request.angles_deg.empty())
                throw Error("the angles of -tape7's runs are not stated",
                            "-angles 0,30,60,85 in their order");
            [[fallthrough]];
        case Source::uvspec:
            if (request.value_unit) throw Error("-L, -K and -C are for files of values");
            break;
        default:
            if (!request.value_unit)
                throw Error("the unit of the values is not stated",
                            "-L radiance in W.m-2.sr-1, -K kelvin, -C degrees Celsius");
            if (request.channels && *request.value_unit == ValueUnit::radiance)
                throw Error("radiances of one band say nothing about channels",
                            "temperatures do, -K or -C, and spectra, -tape7 or -uvspec");
    }
    if (request.passbands.empty() && request.value_unit != ValueUnit::radiance)
        throw Error("no band", "-b 8 12 gives one in um, -r file a spectral response");
    if (request.source == Source::plane && request.sensor.height == 0)
        throw Error("-plane needs the height of the sensor", "-height metres");
}

void check_sun(const Request& request) {
    if (request.sun_angles.has_value() == request.sun_direction)
        throw Error("where is the sun?", "-ang altitude azimuth or -dir x y z, one of them");
    if (request.passbands.empty()) throw Error("no band", "-b 3 5 gives one in um, -r file a response");
}

void check_air(Request& request) {
    if (request.source == Source::none)
        throw Error("nothing to make it from", "-homogeneous, -tape7 or -uvspec");
    if (request.ranges_m.empty()) {
        if (request.source != Source::homogeneous)
            throw Error("the lengths of the runs' paths are not stated", "-ranges 100,1000 in metres");
        request.ranges_m = {1000};
    }
    if (request.passbands.empty()) throw Error("no band", "-b 8 12 gives one in um, -r file a response");
}

void check(Request& request) {
    switch (request.subject) {
        case Subject::sky:
        case Subject::sea:
            return check_dome(request);
        case Subject::sun:
            return check_sun(request);
        case Subject::air:
            return check_air(request);
    }
}

}  // namespace

std::string Request::name_of_subject() const {
    return std::string(subjects[static_cast<std::size_t>(subject)]);
}

std::optional<Request> read_request(int argc, char** argv) {
    Request request;
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::string usage = "sky | sea | sun | air";
    if (words.empty() || (words[0].starts_with("-") && words[0].size() > 1)) {
        OptionTable table("genirsky " + usage);
        table.describe(purpose +
                       std::string("\n\n`genirsky sky -help' lists the options of the sky, and so on."));
        if (!table.parse(std::move(words))) return std::nullopt;
        throw Error("what is it to be?", "genirsky sky, sea, sun or air");
    }
    request.subject = require_subject(words[0]);
    request.name = request.name_of_subject();
    OptionTable table("genirsky " + words[0]);
    describe_options(table, request);
    words.erase(words.begin());
    const auto operands = table.parse(std::move(words));
    if (!operands) return std::nullopt;
    if (!operands->empty())
        throw Error("\"" + operands->front() + "\" is left over",
                    "files come after an option, as -elev file");
    request.command = "genirsky " + request.name_of_subject() +
                      table.command_line().substr(join_command({table.program()}).size());
    // ThRend writes kelvin, RADIANCE's tables need not
    if (request.source == Source::thrend && !request.value_unit) request.value_unit = ValueUnit::kelvin;
    if (split_words(request.name).size() != 1 || split_words(request.name)[0] != request.name)
        throw Error("-id \"" + request.name + "\" is not one word");
    make_channels(request);
    check(request);
    check_unread(request);
    return request;
}

}  // namespace infra::ir
