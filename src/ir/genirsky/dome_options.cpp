// Options of skies and seas.
#include <cmath>

#include "ir/genirsky/option_values.h"
#include "ir/genirsky/options.h"

namespace infra::ir {
namespace {

void add_file(OptionTable& table, Request& request, const char* spelling, Source source, const char* help) {
    table
        .custom(
            spelling, "s",
            [&request, source](const OptionValues& given) {
                choose_source(request, given, source);
                request.files.push_back(given.text(0));
            },
            help)
        .named("file");
}

void add_unit(OptionTable& table, Request& request, const char* spelling, ValueUnit unit, const char* help) {
    table.custom(
        spelling, "",
        [&request, unit](const OptionValues& given) {
            if (request.value_unit && *request.value_unit != unit)
                given.reject("-L, -K and -C exclude one another");
            request.value_unit = unit;
        },
        help);
}

}  // namespace

void add_dome_options(OptionTable& table, Request& request) {
    const bool sky = request.subject == Subject::sky;
    add_file(table, request, "-elev", Source::elevations,
             sky ? "ten values from zenith to horizon, or lines of a zenith angle and a value"
                 : "ten values from straight below to the horizon, or lines of a nadir angle and a value");
    add_file(table, request, "-table", Source::table, "21 times ten values, azimuth by azimuth");
    if (sky)
        add_file(table, request, "-thrend", Source::thrend,
                 "ThRend's line of ten temperatures, K unless -C or -L");
    add_unit(table, request, "-L", ValueUnit::radiance, "values are radiances, W.m-2.sr-1");
    add_unit(table, request, "-K", ValueUnit::kelvin, "values are temperatures of black bodies in kelvin");
    add_unit(table, request, "-C", ValueUnit::celsius, "values are temperatures in degrees Celsius");
    table.custom(
        "-from-horizon", "", [&request](const OptionValues&) { request.from_horizon = true; },
        "the ten values begin at the horizon");
    add_tape7_option(table, request);
    table
        .custom(
            "-angles", "s",
            [&request](const OptionValues& given) {
                request.angles_deg = number_list(given);
                for (const double angle : request.angles_deg)
                    if (!(angle >= 0 && angle <= 90)) given.reject("angles must be within 0..90 deg");
            },
            sky ? "zenith angles of the runs of -tape7, degrees"
                : "nadir angles of the runs of -tape7, degrees")
        .named("0,30,60,85");
    add_uvspec_options(table, request);
    table
        .custom(
            "-umu", "s",
            [&request](const OptionValues& given) {
                request.uvspec.umu = number_list(given);
                for (const double umu : request.uvspec.umu)
                    if (umu == 0 || std::abs(umu) > 1) given.reject("umu must be within -1..1 and not 0");
            },
            "umu of uvspec's input, with -columns")
        .named("-1,-.5,-.1");
    table
        .custom(
            "-phi", "s", [&request](const OptionValues& given) { request.uvspec.phi = number_list(given); },
            "phi of uvspec's input, with -columns")
        .named("0,90,180");
}

void add_plane_options(OptionTable& table, Request& request) {
    add_file(table, request, "-plane", Source::plane, "points of the sea: lines of x, y and a value");
    table
        .custom(
            "-height", "f",
            [&request](const OptionValues& given) {
                if (!(given.real(0) > 0)) given.reject("the height must be above 0");
                request.sensor.height = given.real(0);
            },
            "of the sensor above the sea, for -plane")
        .named("metres");
    table
        .custom(
            "-at", "ff",
            [&request](const OptionValues& given) {
                request.sensor.x = given.real(0);
                request.sensor.y = given.real(1);
            },
            "the sensor's place over the sea of -plane; 0 0 otherwise")
        .named("x y");
    table
        .custom(
            "-horizon", "f", [&request](const OptionValues& given) { request.horizon = given.real(0); },
            "value at the horizon of -plane instead of the farthest points'")
        .named("value");
}

}  // namespace infra::ir
