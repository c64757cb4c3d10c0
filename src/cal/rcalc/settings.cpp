#include "settings.h"

#include <cctype>
#include <string_view>

#include "columns.h"
#include "common/error.h"
#include "common/parse_number.h"

namespace infra::rcalc {
namespace {

constexpr const char* usage =
    "rcalc [-b][-l][-n][-p|-P][-w][-u][-tS][-s name=text][-e definitions][-f file]"
    "[-i format|-if N|-id N][-o format|-of|-od][-in M][-on M] [file ..]";

class CommandLine {
  public:
    CommandLine(int argc, char** argv) : words_(argv + 1, argv + argc) {}

    Settings read() {
        while (next_ < words_.size() && words_[next_].starts_with('-')) {
            option_ = words_[next_++];
            read_option();
        }
        settings_.files.assign(words_.begin() + static_cast<std::ptrdiff_t>(next_), words_.end());
        if (settings_.no_input && !settings_.files.empty())
            throw Error("option -n reads no input", "files were named");
        const bool formats = settings_.input_format && settings_.output_format;
        if (settings_.passive != Passive::off && !formats && !settings_.no_input)
            throw Error("options -p and -P need the formats -i and -o");
        return std::move(settings_);
    }

  private:
    [[noreturn]] void unknown() const {
        throw Error("unknown option " + option_, std::string("usage: ") + usage);
    }

    const std::string& argument() {
        if (next_ == words_.size()) throw Error("option " + option_ + " needs an argument");
        return words_[next_++];
    }

    long count() {
        int value = 0;
        if (!parse_int(argument(), value) || value < 0)
            throw Error("option " + option_ + " needs a whole number");
        return value;
    }

    static std::optional<NumberForm> number_form(char letter) {
        switch (letter) {
            case 'a':
                return NumberForm::text;
            case 'f':
                return NumberForm::float32;
            case 'F':
                return NumberForm::float32_swapped;
            case 'd':
                return NumberForm::float64;
            case 'D':
                return NumberForm::float64_swapped;
            default:
                return {};
        }
    }

    void read_option() {
        Settings& s = settings_;
        switch (option_.size() > 1 ? option_[1] : '\0') {
            case 'b':
                s.exact_blanks = !s.exact_blanks;
                break;
            case 'l':
                s.ignore_newlines = !s.ignore_newlines;
                break;
            case 'p':
                s.passive = Passive::unmatched;
                break;
            case 'P':
                s.passive = Passive::unmatched_and_refused;
                break;
            case 'w':
                s.quiet = !s.quiet;
                break;
            case 'u':
                s.unbuffered = !s.unbuffered;
                break;
            case 'n':
                s.no_input = true;
                s.library.set_constant_folding(false);
                break;
            case 't':
                if (option_.size() < 3) throw Error("option -t needs a character joined on", "as in -t,");
                s.separator = option_[2];
                break;
            case 's':
                read_preset();
                break;
            case 'f':
                s.library.load_file(argument());
                break;
            case 'e':
                s.library.define(argument(), Location{"-e", 1, 1});
                break;
            case 'i':
                read_input_option();
                break;
            case 'o':
                read_output_option();
                break;
            default:
                unknown();
        }
    }

    void read_preset() {
        const std::string& equation = argument();
        const std::size_t equals = equation.find('=');
        if (equals == std::string::npos) throw Error("option -s needs name=text, not " + equation);
        settings_.presets[equation.substr(0, equals)] = equation.substr(equals + 1);
    }

    void read_input_option() {
        if (option_ == "-i") {
            settings_.input_form = NumberForm::text;
            settings_.binary_columns = 0;
            settings_.input_format = read_record_format(argument(), settings_.ignore_newlines);
            return;
        }
        if (option_[2] == 'n') {
            settings_.input_limit = count();
            return;
        }
        const auto form = number_form(option_[2]);
        if (!form) unknown();
        settings_.input_form = *form;
        settings_.binary_columns = *form == NumberForm::text ? 0 : 1;
        const std::string columns = option_.substr(3);
        if (*form == NumberForm::text || columns.empty()) return;
        constexpr int most_columns = 1 << 20;
        int number = 0;
        if (!parse_int(columns, number) || number < 1 || number > most_columns)
            throw Error("bad number of columns in option " + option_);
        settings_.binary_columns = static_cast<std::size_t>(number);
    }

    void read_output_option() {
        if (option_ == "-o") {
            settings_.output_form = NumberForm::text;
            RecordFormat format = read_record_format(argument(), settings_.ignore_newlines);
            for (Field& field : format)
                if (field.kind == Field::Kind::number)
                    field.expression = settings_.library.compile(field.text, Location{"-o", 1, 1});
            settings_.output_format = std::move(format);
        } else if (option_[2] == 'n') {
            settings_.output_limit = count();
        } else if (const auto form = number_form(option_[2])) {
            settings_.output_form = *form;
        } else {
            unknown();
        }
    }

    std::vector<std::string> words_;
    std::size_t next_ = 0;
    std::string option_;
    Settings settings_;
};

}  // namespace

Settings::Settings() : library(column_builtins()) {
    library.allow_output_channels(true);
    library.define("PI : 3.14159265358979323846", {});
}

Settings read_command_line(int argc, char** argv) { return CommandLine(argc, argv).read(); }

}  // namespace infra::rcalc
