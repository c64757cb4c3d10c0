// Options of the sun.
#include "common/format.h"
#include "ir/genirsky/option_values.h"
#include "ir/genirsky/options.h"

namespace infra::ir {

void add_sun_options(OptionTable& table, Request& request) {
    Sun& sun = request.sun;
    table
        .custom(
            "-ang", "ff",
            [&request](const OptionValues& given) {
                if (!(given.real(0) >= -90 && given.real(0) <= 90))
                    given.reject("the altitude must be within -90..90 deg");
                request.sun_angles = {given.real(0), given.real(1)};
            },
            "where it stands: degrees above the horizon, azimuth as in the tables of the sky")
        .named("altitude azimuth");
    table
        .custom(
            "-dir", "fff",
            [&request](const OptionValues& given) {
                const Vec3 towards{given.real(0), given.real(1), given.real(2)};
                if (!(length(towards) > 0)) given.reject("the direction has no length");
                request.sun.direction = normalize(towards);
                request.sun_direction = true;
            },
            "the same as a direction of the scene")
        .named("x y z");
    table
        .custom(
            "-t", "f", [&sun](const OptionValues& given) { sun.temperature = kelvin(given, 0); },
            "temperature of the disk, kelvin")
        .named("kelvin")
        .shown([&sun] { return formatted("-t %g", sun.temperature); });
    table
        .custom(
            "-half-angle", "f",
            [&sun](const OptionValues& given) {
                constexpr double least = 1e-4;  // renderers take less for no disk at all
                if (!(given.real(0) >= least && given.real(0) <= 90))
                    given.reject(formatted("the half-angle must be within %g..90 deg", least));
                sun.half_angle_deg = given.real(0);
            },
            "half the angle that the disk spans, degrees")
        .named("degrees")
        .shown([&sun] { return formatted("-half-angle %g", sun.half_angle_deg); });
    table
        .custom(
            "-trans", "f",
            [&sun](const OptionValues& given) {
                if (!(given.real(0) >= 0 && given.real(0) <= 1)) given.reject("must be within 0..1");
                sun.transmittance = given.real(0);
            },
            "transmittance of the air before it, in the band")
        .named("transmittance")
        .shown([&sun] { return formatted("-trans %g", sun.transmittance); });
    add_tape7_option(table, request);
}

}  // namespace infra::ir
