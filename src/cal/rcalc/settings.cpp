#include "settings.h"

#include <string>

#include "columns.h"
#include "common/error.h"
#include "common/parse_number.h"

namespace infra::rcalc {
namespace {

struct FormLetter {
    char letter;
    NumberForm form;
    const char* name;
};
constexpr FormLetter form_letters[] = {
    {'a', NumberForm::text, "text"},
    {'f', NumberForm::float32, "floats"},
    {'F', NumberForm::float32_swapped, "floats of the other byte order"},
    {'d', NumberForm::float64, "doubles"},
    {'D', NumberForm::float64_swapped, "doubles of the other byte order"},
};

void add_input_rows(OptionTable& options, Settings& s) {
    options
        .custom(
            "-i", "s",
            [&s](const OptionValues& given) {
                s.input_form = NumberForm::text;
                s.binary_columns = 0;
                s.input_format = read_record_format(given.text(0), s.ignore_newlines);
            },
            "format of input records, or a file that holds it")
        .named("format");
    for (const FormLetter& row : form_letters) {
        const auto set = [&s, form = row.form](const OptionValues& given) {
            constexpr int most_columns = 1 << 20;
            int columns = form == NumberForm::text ? 0 : 1;
            if (!given.attached.empty() &&
                (!parse_int(given.attached, columns) || columns < 1 || columns > most_columns))
                given.reject("bad number of columns");
            s.input_form = form;
            s.binary_columns = static_cast<std::size_t>(columns);
        };
        const std::string spelling = std::string("-i") + row.letter;
        if (row.form == NumberForm::text)
            options.custom(spelling, "", set, "the input is text");
        else
            options.attached(spelling, "", set,
                             std::string("the input is ") + row.name + ", so many a record as is joined on");
    }
    options
        .custom(
            "-in", "i", [&s](const OptionValues& given) { s.input_limit = given.integer(0); },
            "records to read from a file")
        .named("number")
        .at_least(0);
}

void add_output_rows(OptionTable& options, Settings& s) {
    options
        .custom(
            "-o", "s",
            [&s](const OptionValues& given) {
                s.output_form = NumberForm::text;
                RecordFormat format = read_record_format(given.text(0), s.ignore_newlines);
                for (Field& field : format)
                    if (field.kind == Field::Kind::number)
                        field.expression = s.library.compile(field.text, Location{"-o", 1, 1});
                s.output_format = std::move(format);
            },
            "format of output records, or a file that holds it")
        .named("format");
    for (const FormLetter& row : form_letters)
        options.custom(
            std::string("-o") + row.letter, "",
            [&s, form = row.form](const OptionValues&) { s.output_form = form; },
            std::string("the output is ") + row.name);
    options
        .custom(
            "-on", "i", [&s](const OptionValues& given) { s.output_limit = given.integer(0); },
            "records to write for a file")
        .named("number")
        .at_least(0);
}

void add_definition_rows(OptionTable& options, Settings& s) {
    options
        .custom(
            "-e", "s",
            [&s](const OptionValues& given) {
                s.library.define(given.text(0), Location{"-e", 1, 1});
            },
            "definitions")
        .named("definitions");
    options
        .custom(
            "-f", "s", [&s](const OptionValues& given) { s.library.load_file(given.text(0)); },
            "file of definitions")
        .named("file.cal");
    options
        .custom(
            "-s", "s",
            [&s](const OptionValues& given) {
                const std::string& equation = given.text(0);
                const std::size_t equals = equation.find('=');
                if (equals == std::string::npos) given.reject("expected name=text");
                s.presets[equation.substr(0, equals)] = equation.substr(equals + 1);
            },
            "gives a text to a field; only records that agree are taken")
        .named("name=text");
}

}  // namespace

OptionTable option_table(Settings& s) {
    OptionTable options("rcalc", "[file ..]");
    options.describe("Calculates with the numbers of each record of the files, or of the standard input.");
    options.take_words_literally();
    const auto flip = [&options](const char* spelling, bool& target, const char* help) {
        options.custom(
            spelling, "", [&target](const OptionValues&) { target = !target; }, help);
    };
    flip("-b", s.exact_blanks, "blanks must match the input format");
    flip("-l", s.ignore_newlines, "line ends count as blanks");
    flip("-w", s.quiet, "no warnings");
    flip("-u", s.unbuffered, "write each record at once");
    options.custom(
        "-p", "", [&s](const OptionValues&) { s.passive = Passive::unmatched; },
        "pass on what does not match the input format");
    options.custom(
        "-P", "", [&s](const OptionValues&) { s.passive = Passive::unmatched_and_refused; },
        "the same, and records for which cond is not positive");
    options.custom(
        "-n", "",
        [&s](const OptionValues&) {
            s.no_input = true;
            s.library.set_constant_folding(false);
        },
        "no input: one record");
    options.attached(
        "-t", "",
        [&s](const OptionValues& given) {
            if (given.attached.empty()) given.reject("needs a character joined on", "as in -t,");
            s.separator = given.attached[0];
        },
        "the character joined on separates columns");
    add_definition_rows(options, s);
    add_input_rows(options, s);
    add_output_rows(options, s);
    return options;
}

Settings::Settings() : library(column_builtins()) {
    library.allow_output_channels(true);
    library.define("PI : 3.14159265358979323846", {});
}

bool read_command_line(int argc, char** argv, Settings& settings) {
    const auto files = option_table(settings).parse(argc, argv);
    if (!files) return false;
    settings.files = *files;
    if (settings.no_input && !settings.files.empty())
        throw Error("option -n reads no input", "files were named");
    const bool formats = settings.input_format && settings.output_format;
    if (settings.passive != Passive::off && !formats && !settings.no_input)
        throw Error("options -p and -P need the formats -i and -o");
    return true;
}

}  // namespace infra::rcalc
