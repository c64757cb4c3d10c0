#include "common/options.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"
#include "common/version.h"

namespace infra {
namespace {

/// @file and $NAME may name one another; this many replacements can only be a circle.
constexpr int most_expansions = 1000;

[[noreturn]] void command_line_error(std::string_view place, std::string_view what,
                                     std::string_view hint = {}) {
    throw Error("command line error at '" + std::string(place) + "': " + std::string(what), hint);
}

/// Words of an option file; '#' at the start of a word makes the rest of the line a remark.
std::vector<std::string> words_of_file(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        for (std::string& word : split_words(take_line(text))) {
            if (word[0] == '#') break;
            words.push_back(std::move(word));
        }
    }
    return words;
}

/// What "@file" or "$NAME" stands for.
std::vector<std::string> expansion(const std::string& word) {
    if (word[0] == '@') return words_of_file(read_text_file(word.substr(1)));
    const char* value = std::getenv(word.c_str() + 1);
    if (!value) command_line_error(word, "there is no such environment variable");
    return split_words(value);
}

bool expandable(const std::string& word) { return word.size() > 1 && (word[0] == '@' || word[0] == '$'); }
/// A negative number is none: it is a value given to the program.
bool is_option(const std::string& word) {
    double number = 0;
    return word.size() > 1 && word[0] == '-' && !parse_real(word, number);
}

/// Whether `suffix` after a toggle's spelling sets it.
bool is_toggle_suffix(std::string_view suffix) {
    return suffix == "+" || suffix == "-" || suffix == "1" || suffix == "0";
}

/// Fewer arguments than the option takes before the next option or the end.
[[noreturn]] void missing_arguments(const OptionRow& row, std::string_view option) {
    const std::size_t count = std::min(row.pattern.size(), row.required);
    const bool numbers = row.pattern.find('s') == std::string::npos;
    const std::string what = count == 1 ? (numbers ? "needs a number" : "needs an argument")
                                        : formatted("needs %zu %s", count, numbers ? "numbers" : "arguments");
    command_line_error(option, what, "usage: " + row.spelling + " " + row.arguments);
}

/// Whether a word can be an optional argument of this kind: a number.
bool fits(char kind, const std::string& word) {
    double real = 0;
    int integer = 0;
    return kind == 'i' ? parse_int(word, integer) : kind == 'f' && parse_real(word, real);
}

void check_value(const OptionRow& row, char kind, std::string_view option, const std::string& value) {
    const std::string place = std::string(option) + " " + value;
    double number = 0;
    if (kind == 's') return;
    if (kind == 'i') {
        int integer = 0;
        if (!parse_int(value, integer)) command_line_error(place, "expected an integer");
        number = integer;
    } else if (!parse_real(value, number)) {
        command_line_error(place, "expected a number");
    }
    if (row.minimum && number < *row.minimum)
        command_line_error(place, formatted("expected a number of at least %g", *row.minimum));
}

}  // namespace

double OptionValues::real(std::size_t i) const {
    double value = 0;
    parse_real(values[i], value);
    return value;
}

int OptionValues::integer(std::size_t i) const {
    int value = 0;
    parse_int(values[i], value);
    return value;
}

void OptionValues::reject(std::string_view why, std::string_view hint) const {
    std::string place(option);
    for (const std::string& value : values) place += " " + value;
    command_line_error(place, why, hint);
}

/// A word with a dash that is no number, or one that a row spells otherwise ("+d").
bool OptionTable::begins_option(const std::string& word) const {
    return is_option(word) ||
           std::ranges::any_of(rows_, [&](const OptionRow& row) { return row.spelling == word; });
}

const OptionRow* OptionTable::find(std::string_view word, std::string_view& attached) const {
    attached = {};
    const OptionRow* best = nullptr;
    for (const OptionRow& row : rows_) {
        if (!word.starts_with(row.spelling)) continue;
        const std::string_view suffix = word.substr(row.spelling.size());
        if (suffix.empty() && row.form != OptionRow::Form::attached) return &row;
        const bool fits = row.form == OptionRow::Form::attached ||
                          (row.form == OptionRow::Form::toggle && is_toggle_suffix(suffix));
        if (fits && (!best || row.spelling.size() > best->spelling.size())) best = &row;
    }
    if (best) attached = word.substr(best->spelling.size());
    return best;
}

std::string OptionTable::near_spelling(std::string_view word) const {
    const auto without_dash = [](std::string_view spelling) { return spelling.substr(1); };
    std::vector<std::string_view> known{"defaults", "help", "version"};
    for (const OptionRow& row : rows_)
        if (row.unsupported.empty()) known.push_back(without_dash(row.spelling));
    const std::string near = nearest_name(without_dash(word), known);
    return near.empty() ? near : "-" + near;
}

std::size_t OptionTable::apply(const OptionRow& row, std::string_view attached,
                               const std::vector<std::string>& words, std::size_t i) const {
    const std::string& word = words[i];
    if (!row.unsupported.empty()) command_line_error(word, "option is not supported", row.unsupported);
    const std::size_t left = words.size() - i - 1;
    std::size_t count = std::min(row.pattern.size(), row.required);
    if (left < count) missing_arguments(row, word);
    if (row.form == OptionRow::Form::rest) {
        row.apply({word, attached, std::span(words).subspan(i + 1)});
        return left;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::string& value = words[i + 1 + k];
        if (row.pattern[k] != 's' && is_option(value)) missing_arguments(row, word);
        check_value(row, row.pattern[k], word, value);
    }
    while (count < row.pattern.size() && i + 1 + count < words.size() &&
           fits(row.pattern[count], words[i + 1 + count])) {
        check_value(row, row.pattern[count], word, words[i + 1 + count]);
        ++count;
    }
    row.apply({word, attached, std::span(words).subspan(i + 1, count)});
    return count;
}

std::optional<std::vector<std::string>> OptionTable::parse(int argc, char** argv) {
    return parse(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
}

std::optional<std::vector<std::string>> OptionTable::parse(std::vector<std::string> words) {
    if (!environment_.empty() && std::getenv(environment_.c_str()))
        words.insert(words.begin(), "$" + environment_);
    applied_.clear();
    int expansions = 0;
    std::size_t i = 0;
    while (i < words.size()) {
        if (!literal_ && expandable(words[i])) {
            const std::vector<std::string> replacement = expansion(words[i]);
            if (++expansions > most_expansions) command_line_error(words[i], "refers to itself");
            words.erase(words.begin() + i);
            words.insert(words.begin() + i, replacement.begin(), replacement.end());
            continue;
        }
        if (!begins_option(words[i])) break;
        if (words[i] == "-version" || words[i] == "-defaults" || words[i] == "-help") {
            const std::string answer = words[i] == "-version"    ? version_string() + std::string("\n")
                                       : words[i] == "-defaults" ? defaults()
                                                                 : help();
            std::fputs(answer.c_str(), stdout);
            return std::nullopt;
        }
        std::string_view attached;
        const OptionRow* row = find(words[i], attached);
        if (!row) {
            const std::string near = near_spelling(words[i]);
            command_line_error(words[i], "unknown option",
                               near.empty() ? "-help lists the options" : "did you mean '" + near + "'?");
        }
        const std::size_t taken = apply(*row, attached, words, i) + 1;
        applied_.push_back({row->spelling, {words.begin() + i, words.begin() + i + taken}});
        i += taken;
    }
    words.erase(words.begin(), words.begin() + i);
    return words;
}

std::string OptionTable::command_line() const { return command_line_without({}); }

std::string OptionTable::command_line_without(std::span<const std::string_view> spellings) const {
    std::vector<std::string> words{program_};
    for (const Applied& option : applied_)
        if (std::ranges::find(spellings, option.spelling) == spellings.end())
            words.insert(words.end(), option.words.begin(), option.words.end());
    return join_command(words);
}

}  // namespace infra
