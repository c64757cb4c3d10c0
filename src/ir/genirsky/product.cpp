#include "ir/genirsky/product.h"

#include <algorithm>

#include "common/error.h"
#include "common/format.h"
#include "ir/genirsky/air.h"
#include "ir/genirsky/atmosphere.h"
#include "ir/genirsky/scene_text.h"

namespace infra::ir {
namespace {

using Warnings = std::vector<std::string>;

/// The radiance itself. throws Error where it is far beyond what single precision and good sense hold
double renderable(double radiance) {
    constexpr double largest = 1e30;
    if (!(radiance <= largest)) throw Error(formatted("radiance %g is beyond %g", radiance, largest));
    return radiance;
}

std::string comment(const std::string& text) { return "# " + one_line(text) + "\n"; }

std::string band_words(const Request& request) {
    if (request.channels)
        return request.channels->description() + ", each its band's radiance times their number";
    return request.passbands.empty() ? "band not stated" : request.passbands[0].description();
}

std::string source_words(const Request& request) {
    std::string text;
    for (const std::string& file : request.files) text += (text.empty() ? "" : " ") + shown_name(file);
    switch (request.source) {
        case Source::none:
            return "Planck's law";
        case Source::homogeneous:
            return formatted("homogeneous air of %g K, extinction %g per metre", request.air_temperature,
                             request.air_extinction);
        case Source::tape7:
            return text + ", MODTRAN tape7";
        case Source::uvspec:
            return text + ", uvspec" +
                   (request.uvspec.unit ? " in " + std::string(request.uvspec.unit->name()) : "");
        case Source::thrend:
            text += ", ThRend's line";
            break;
        case Source::plane:
            text += formatted(", points of the sea seen from %g m above %g %g", request.sensor.height,
                              request.sensor.x, request.sensor.y);
            break;
        default:
            break;
    }
    return text + (request.value_unit == ValueUnit::radiance ? ", radiances"
                   : request.value_unit == ValueUnit::kelvin ? ", temperatures in K"
                                                             : ", temperatures in degrees C");
}

std::string head(const Request& request, const std::string& quantity) {
    return comment(request.command) + comment(quantity + " in W.m-2.sr-1, " + band_words(request)) +
           comment("from " + source_words(request));
}

Dome plane_dome(const Request& request, const NumberText& text, const ValueReader& reader) {
    Dome dome = project_sea(parse_sea_points(text, reader), request.sensor, request.frame);
    if (!request.horizon) return dome;
    const double value = reader.radiance({*request.horizon, 0, 0}, NumberText{"-horizon", {}, 0});
    for (std::size_t i = Dome::rows - 1; i < dome.values.size(); i += Dome::rows) dome.values[i] = value;
    return dome;
}

Dome value_dome(const Request& request, const NumberText& text, const Passband* passband,
                std::vector<std::string>* odd) {
    const ValueReader reader(*request.value_unit, passband, odd);
    switch (request.source) {
        case Source::elevations:
            return parse_elevations(text, reader, request.from_horizon);
        case Source::thrend:
            return parse_thrend(text, reader, request.from_horizon);
        case Source::plane:
            return plane_dome(request, text, reader);
        default:
            return parse_dome_table(text, reader);
    }
}

/// A dome of a file of values for each passband; one in all where no band is stated.
std::vector<Dome> value_domes(const Request& request, Warnings& warnings) {
    const NumberText text = read_numbers(request.files[0]);
    std::vector<Dome> domes;
    Warnings odd;  // the same in all bands
    for (const Passband& passband : request.passbands)
        domes.push_back(value_dome(request, text, &passband, domes.empty() ? &odd : nullptr));
    if (domes.empty()) domes.push_back(value_dome(request, text, nullptr, nullptr));
    if (odd.size() == 1) warnings.push_back(odd[0]);
    if (odd.size() > 1)
        warnings.push_back(odd[0] + formatted(", and %zu more such %s", odd.size() - 1,
                                              odd.size() == 2 ? "value" : "values"));
    return domes;
}

/// The pole is one direction, which a table's rows need not know.
void join_poles(std::vector<Dome>& domes, const Request& request, Warnings& warnings) {
    bool differed = false;
    for (Dome& dome : domes) differed = dome.join_pole() || differed;
    if (differed && request.source == Source::table)
        warnings.push_back(shown_name(request.files[0]) + ": the " +
                           (request.subject == Subject::sky ? "zenith" : "nadir") +
                           " has different values by azimuth: their mean is taken");
}

/// One for each passband; one in all where no band is stated.
std::vector<Dome> make_domes(const Request& request, Warnings& warnings) {
    std::vector<Dome> domes;
    if (request.source == Source::tape7) {
        const std::vector<Tape7Run> runs = read_runs(request.files);
        for (const Passband& passband : request.passbands)
            domes.push_back(dome_of_runs(runs, request.angles_deg, passband));
    } else if (request.source == Source::uvspec) {
        std::vector<UvspecRadiance> radiances;
        for (const std::string& file : request.files)
            for (UvspecRadiance& radiance : parse_uvspec(read_numbers(file), request.uvspec))
                radiances.push_back(std::move(radiance));
        for (const Passband& passband : request.passbands)
            domes.push_back(dome_of_uvspec(radiances, request.subject == Subject::sky, passband));
    } else {
        domes = value_domes(request, warnings);
    }
    join_poles(domes, request, warnings);
    for (Dome& dome : domes)
        for (double& value : dome.values) value = renderable(value * request.channel_factor());
    return domes;
}

std::string dome_product(const Request& request, Warnings& warnings) {
    const std::vector<Dome> domes = make_domes(request, warnings);
    const bool sky = request.subject == Subject::sky;
    std::string order = sky ? "by zenith angle" : "by nadir angle";
    order += " 0, 10 .. 90 deg";
    if (!sky || domes[0].has_azimuth())
        order += ", ten for each azimuth 0, 18 .. 360 deg (clockwise seen from above)";
    return head(request, sky ? "sky radiance" : "sea radiance") + comment(order) + "\n" +
           dome_text(request, domes);
}

std::string sun_product(Request request) {
    Sun& sun = request.sun;
    if (request.sun_angles)
        sun.direction = request.frame.direction(request.sun_angles->first, request.sun_angles->second);
    std::vector<Tape7Run> runs = read_runs(request.files);
    if (runs.size() > 1) throw Error("the sun has one path, but the files hold several runs");
    const double own = sun.transmittance;
    std::vector<double> radiances;
    double irradiance = 0;
    for (const Passband& passband : request.passbands) {
        sun.transmittance =
            runs.empty() ? own : own * band_mean(runs[0].transmittance, passband, sun.temperature);
        const double radiance = sun.radiance(passband);
        irradiance += radiance * sun.solid_angle();
        radiances.push_back(renderable(request.channel_factor() * radiance));
    }
    return head(request, "sun radiance") +
           comment(formatted("disk of %g K, half-angle %g deg, %.6g sr; irradiance facing it %.6g W.m-2",
                             sun.temperature, sun.half_angle_deg, sun.solid_angle(), irradiance)) +
           "\n" + sun_text(request, radiances);
}

std::string air_product(const Request& request, Warnings& warnings) {
    if (request.source == Source::homogeneous)
        if (const std::string odd = oddity(request.air_temperature); !odd.empty())
            warnings.push_back(formatted("-homogeneous: temperature %g K is %s (degrees Celsius?)",
                                         request.air_temperature, odd.c_str()));
    std::vector<Passband> passbands = request.passbands;
    // channels begin with the longest wavelengths, files of air with the shortest
    std::ranges::reverse(passbands);
    Request ordered = request;
    ordered.passbands = passbands;
    std::vector<AirRow> rows;
    if (request.source == Source::tape7) rows = air_of_runs(read_runs(request.files), ordered);
    if (request.source == Source::uvspec) rows = air_of_columns(ordered);
    if (request.source == Source::homogeneous)
        for (const double range : request.ranges_m)
            rows.push_back(
                homogeneous_air(request.air_temperature, request.air_extinction, range, passbands));
    for (const AirRow& row : rows)
        for (const AirValue& value : row.values) renderable(value.radiance);
    check_air(rows);
    const std::string bands =
        request.channels ? formatted("%d bands", request.channels->count()) : band_words(request);
    const std::string weight =
        request.source == Source::homogeneous
            ? ""
            : formatted(", transmittances weighted by the spectrum of %g K", request.weight_temperature);
    return comment(request.command) +
           comment("distance in metres, then transmittance and path radiance in W.m-2.sr-1, " + bands) +
           comment("from " + source_words(request) + weight) + air_text(rows, passbands);
}

}  // namespace

Product make_product(const Request& request) {
    Product product;
    switch (request.subject) {
        case Subject::sun:
            product.text = sun_product(request);
            break;
        case Subject::air:
            product.text = air_product(request, product.warnings);
            break;
        default:
            product.text = dome_product(request, product.warnings);
    }
    return product;
}

}  // namespace infra::ir
