// Options of the air along a path.
#include "common/format.h"
#include "ir/genirsky/option_values.h"
#include "ir/genirsky/options.h"

namespace infra::ir {

void add_air_options(OptionTable& table, Request& request) {
    table
        .custom(
            "-homogeneous", "ff",
            [&request](const OptionValues& given) {
                choose_source(request, given, Source::homogeneous);
                request.air_temperature = kelvin(given, 0);
                request.air_extinction = given.real(1);
                if (!(request.air_extinction > 0)) given.reject("the extinction must be above 0 per metre");
            },
            "absorbing air of one temperature, the same everywhere; extinction per metre")
        .named("kelvin extinction");
    add_tape7_option(table, request);
    add_uvspec_options(table, request);
    table
        .custom(
            "-ranges", "s",
            [&request](const OptionValues& given) {
                request.ranges_m = number_list(given);
                for (std::size_t i = 0; i < request.ranges_m.size(); ++i)
                    if (!(request.ranges_m[i] > (i == 0 ? 0 : request.ranges_m[i - 1])))
                        given.reject("ranges must be above 0 and increase");
            },
            "lengths of the runs' paths in metres; of -homogeneous 1000 if not given")
        .named("100,1000,5000");
    table
        .custom(
            "-weight", "f",
            [&request](const OptionValues& given) { request.weight_temperature = kelvin(given, 0); },
            "temperature of what is seen: its spectrum weights the transmittances")
        .named("kelvin")
        .shown([&request] { return formatted("-weight %g", request.weight_temperature); });
    table.text("-o", &request.output, "file to write, otherwise the standard output").named("file.air");
}

}  // namespace infra::ir
