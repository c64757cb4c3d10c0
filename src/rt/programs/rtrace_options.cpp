#include "rt/programs/rtrace_options.h"

#include "common/error.h"
#include "common/format.h"

namespace infra {
namespace {

/// "-fad": a for the input, d for the output; one letter stands for both.
void set_formats(RtraceOptions& options, const OptionValues& given) {
    const std::string_view letters = given.attached;
    const std::string_view known = "afdc";
    const bool good = (letters.size() == 1 || letters.size() == 2) && known.find(letters.front()) < 3 &&
                      known.find(letters.back()) < known.size();
    if (!good) given.reject("unknown format", "input a, f or d, then output a, f, d or c, as in -ffa");
    options.input = static_cast<NumberFormat>(letters.front());
    options.output = static_cast<NumberFormat>(letters.back());
}

void add_stream_rows(OptionTable& table, RtraceOptions& options) {
    RtraceOptions* const o = &options;
    table.toggle("-I", &options.immediate_irradiance, "immediate irradiance").shown({});
    table.integer("-n", &options.threads, "number of rendering processes")
        .at_least(1)
        .differing("threads that give the same numbers for any -n while -aa is 0")
        .shown([o] { return formatted("-n %-2d", o->threads); });
    table.integer("-x", &options.width, "x resolution, or rays between flushes").at_least(0).remark([o] {
        return o->width && o->height ? "x resolution" : "flush interval";
    });
    table.integer("-y", &options.height, "y resolution").at_least(0);
    table.toggle("-ld", &options.limit_distance, "limit distance");
    table.toggle("-h", &options.header, "output header", "no header");
    table
        .attached(
            "-f", "", [o](const OptionValues& given) { set_formats(*o, given); },
            "format of input and output: a text, f float, d double, c color (output only)")
        .shown([o] { return formatted("-f%c%c", static_cast<char>(o->input), static_cast<char>(o->output)); })
        .remark([o] {
            return std::string("format input/output = ") + format_name(o->input, o->color) + "/" +
                   format_name(o->output, o->color);
        });
    std::string help = "output:";
    for (const OutputLetter& letter : output_letters())
        help += formatted(" %c %s,", letter.letter, letter.name);
    help += " t the tree of rays, T and those towards light sources";
    table
        .attached(
            "-o", "", [o](const OptionValues& given) { o->letters = given.attached; }, help)
        .differing("R and X through a medium count its loss in the mirror image too")
        .shown([o] { return formatted("-o%-9s", o->letters.c_str()); })
        .remark([o] { return "output" + output_names(o->letters); });
}

}  // namespace

std::uint64_t RtraceOptions::ray_limit() const {
    const auto rows = static_cast<std::uint64_t>(std::max(height, 0));
    return width > 1 ? rows * static_cast<std::uint64_t>(width) : rows;
}

OptionTable rtrace_option_table(RtraceOptions& options) {
    OptionTable table("rtrace", "octree");
    table.read_environment("RENDER_OPTIONS");
    add_warning_option(table, options.render);
    add_stream_rows(table, options);
    add_primaries_rows(table, options.color);
    add_response_rows(table, options.color);
    add_spectrum_row(table, options.color, options.render.channel_count)
        .differing(
            "after -pXYZ, -pY, -pS or -pM it writes the channels, where RADIANCE keeps their factor of 179 "
            "or 412");
    add_render_options(table, options.render);
    add_name_filter(table, "-t", options.tree_filter, "in the tree of -ot");
    return table;
}

OutputSpec output_spec(const RtraceOptions& options, const WarningSink& warn) {
    const OutputSpec spec = parse_output(options.letters);
    const bool irradiance = options.render.settings.irradiance || options.immediate_irradiance;
    if (options.output == NumberFormat::color && options.letters != "v" && options.letters != "r" &&
        options.letters != "x")
        throw Error("color format only with -ov, -or, -ox");
    if (options.output == NumberFormat::color && options.color.is_single())
        throw Error("color format incompatible with -pY, -pS, -pM, -pA",
                    "they write one number, a pixel has three");
    if (irradiance && !spec.needs_radiance())
        throw Error("-I+ and -i+ options require some value output", "add v to the letters of -o");
    if (spec.has_any("VW")) warn("-oVW options require trace mode");
    if (irradiance && spec.has_any("rRxX")) warn("-orRxX options incompatible with -I+ and -i+");
    return spec;
}

}  // namespace infra
