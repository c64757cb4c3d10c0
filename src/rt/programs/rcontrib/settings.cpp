#include "rt/programs/rcontrib/settings.h"

#include <algorithm>
#include <cctype>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/raypath.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra {
namespace {

constexpr const char* definition_context = "RC.";

/// "-fad": a for the input, d for the output; one letter stands for both.
void set_formats(RcontribSettings& settings, const OptionValues& given) {
    const std::string_view letters = given.attached;
    const std::string_view known = "afdc";
    const bool good = (letters.size() == 1 || letters.size() == 2) && known.find(letters.front()) < 3 &&
                      known.find(letters.back()) < known.size();
    if (!good) given.reject("unknown format", "input a, f or d, then output a, f, d or c, as in -ffa");
    settings.input = static_cast<NumberFormat>(letters.front());
    settings.output = static_cast<NumberFormat>(letters.back());
}

void add_modifier(RcontribSettings& settings, const std::string& name) {
    const auto same = [&name](const TrackedModifier& other) { return other.name == name; };
    if (std::ranges::any_of(settings.modifiers, same)) throw Error("duplicate modifier '" + name + "'");
    if (name == "void")
        throw Error("cannot track 'void' modifier", "surfaces without a modifier are not seen");
    TrackedModifier& modifier = settings.modifiers.emplace_back(settings.next);
    modifier.name = name;
    modifier.width = settings.width;
    modifier.height = settings.height;
}

void add_record_rows(OptionTable& table, RcontribSettings& settings) {
    RcontribSettings* const s = &settings;
    table.integer("-c", &settings.accumulate, "accumulated rays per record")
        .at_least(0)
        .differing("a last record of fewer rays is written with any -n, divided by their number")
        .shown([s] { return formatted("-c %-5d", s->accumulate); });
    table.toggle("-V", &settings.contributions, "output contributions", "output coefficients")
        .differing(
            "coefficients of 1e-6 and less count too; weights of samples and the scattering of a medium are "
            "in them, so that coefficients times radiances sum to what rtrace says");
    table.toggle("-I", &settings.immediate_irradiance, "immediate irradiance").shown({});
    table.integer("-n", &settings.threads, "number of rendering processes")
        .at_least(1)
        .differing("threads that give the same numbers for any -n")
        .shown([s] { return formatted("-n %-2d", s->threads); });
    table.integer("-x", &settings.width, "x resolution, or records between flushes").at_least(0).remark([s] {
        return s->width && s->height ? "x resolution" : "flush interval";
    });
    table.integer("-y", &settings.height, "y resolution").at_least(0);
    table.toggle("-ld", &settings.limit_distance, "limit distance");
    table.toggle("-h", &settings.header, "output header", "no header");
    table
        .attached(
            "-f", "", [s](const OptionValues& given) { set_formats(*s, given); },
            "format of input and output: a text, f float, d double, c color (output only)")
        .shown([s] { return formatted("-f%c%c", static_cast<char>(s->input), static_cast<char>(s->output)); })
        .remark([s] {
            const OutputColor color = for_channels({OutputColor::Kind::spectrum}, s->render.channels());
            return std::string("format input/output = ") + format_name(s->input, color) + "/" +
                   format_name(s->output, color);
        });
    table.integer("-t", &settings.report_seconds, "time between reports").at_least(0).shown([s] {
        return s->report_seconds > 0 ? formatted("-t %-9d", s->report_seconds) : "";
    });
}

void add_modifier_rows(OptionTable& table, RcontribSettings& settings) {
    RcontribSettings* const s = &settings;
    table
        .custom(
            "-m", "s", [s](const OptionValues& given) { add_modifier(*s, given.text(0)); },
            "a modifier whose surfaces are looked out for")
        .named("name");
    table
        .custom(
            "-M", "s",
            [s](const OptionValues& given) {
                const std::string path = require_library_file(given.text(0), "list of modifiers");
                for (const std::string& name : split_words(read_text_file(path))) add_modifier(*s, name);
            },
            "the modifiers in this file")
        .named("file");
    table
        .custom(
            "-o", "s", [s](const OptionValues& given) { s->next.output = given.text(0); },
            "output of the modifiers that follow: a file, or !command; %s stands for the modifier, %d for "
            "the "
            "bin")
        .named("file|!command");
    table
        .custom(
            "-b", "s", [s](const OptionValues& given) { s->next.bin = given.text(0); },
            "expression of the bin for the modifiers that follow")
        .named("expression");
    table
        .custom(
            "-bn", "s",
            [s](const OptionValues& given) {
                s->next.bin_count = given.text(0);
                s->next.count_parameters = s->next.parameters;
                s->next.count_definitions = s->render.definitions.size();
            },
            "number of bins of the modifiers that follow")
        .named("expression");
    table
        .custom(
            "-p", "s",
            [s](const OptionValues& given) {
                parse_parameters(given.text(0));
                s->next.parameters = given.text(0);
            },
            "values of variables in the expressions of the modifiers that follow")
        .named("name=value,..")
        .differing("modifiers before it do not see them");
    table.toggle("-fo", &settings.force, "write over existing files").shown({});
    table.toggle("-r", &settings.recover, "go on where existing files end; with -c 0: add to them")
        .differing("with -c 0 the new rays take other random numbers than those before")
        .shown({});
}

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

}  // namespace

std::uint64_t RcontribSettings::record_limit() const {
    if (accumulate == 0 || height <= 0) return 0;
    return static_cast<std::uint64_t>(height) * static_cast<std::uint64_t>(std::max(width, 1));
}

std::uint64_t RcontribSettings::ray_limit() const {
    return record_limit() * static_cast<std::uint64_t>(accumulate);
}

void RcontribSettings::apply_overrides() {
    render.settings.shadow_threshold = 0;
    render.settings.ambient_super_samples = 0;
    render.settings.ambient_accuracy = 0;
    for (FunctionDefinition& definition : render.definitions) definition.context = definition_context;
    if (accumulate == 0) width = height = 0;  // there is one record
}

OptionTable rcontrib_option_table(RcontribSettings& settings) {
    OptionTable table("rcontrib", "octree");
    add_record_rows(table, settings);
    add_warning_option(table, settings.render);
    add_transport_options(table, settings.render);
    add_photon_search_rows(table, settings.render.settings);
    add_modifier_rows(table, settings);
    table.unsupported("-ap", "sii", "contribution photon maps (mkpmap -apC) are not read yet");
    add_last_rows(table, settings.render);
    return table;
}

std::vector<BinParameter> parse_parameters(const std::string& text) {
    std::vector<BinParameter> parameters;
    const auto refuse = [&text]() -> void {
        throw Error("bad parameter list '" + text + "'", "names and numbers, as in -p MF=4,RHS=-1");
    };
    std::size_t i = 0;
    const auto skip_blanks = [&] {
        while (i < text.size() && is_blank(text[i])) ++i;
    };
    for (skip_blanks(); i < text.size(); skip_blanks()) {
        BinParameter parameter;
        if (!std::isalpha(static_cast<unsigned char>(text[i]))) refuse();
        while (i < text.size() && is_name_character(text[i])) parameter.name += text[i++];
        skip_blanks();
        if (i == text.size() || text[i++] != '=') refuse();
        skip_blanks();
        std::string number;
        while (i < text.size() && !is_blank(text[i]) &&
               std::string_view(",;:").find(text[i]) == std::string_view::npos)
            number += text[i++];
        if (!parse_real(number, parameter.value)) refuse();
        parameters.push_back(std::move(parameter));
        skip_blanks();
        if (i < text.size() && std::string_view(",;:").find(text[i]) != std::string_view::npos) ++i;
    }
    return parameters;
}

}  // namespace infra
