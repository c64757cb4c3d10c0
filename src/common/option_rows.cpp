// The kinds of option rows, and what -defaults and -help print of them.
#include <algorithm>

#include "common/format.h"
#include "common/options.h"
#include "common/version.h"

namespace infra {
namespace {

/// The remarks of -defaults start in this column, filled with tabs of eight.
constexpr std::size_t remark_column = 32;
/// The texts of -help start in this column, filled with blanks.
constexpr std::size_t help_column = 28;

std::string default_argument_names(const std::string& pattern) {
    std::string names;
    for (const char kind : pattern) {
        if (!names.empty()) names += ' ';
        names += kind == 'i' ? "integer" : kind == 'f' ? "real" : "text";
    }
    return names;
}

std::string shown_real(double value, bool scientific) {
    return scientific ? formatted("%.2e", value) : formatted("%f", value);
}

template <class Real>
OptionRow real_row(std::string spelling, Real* target, std::string help, bool scientific) {
    OptionRow row{.spelling = std::move(spelling), .pattern = "f", .help = std::move(help)};
    row.apply = [target](const OptionValues& given) { *target = static_cast<Real>(given.real(0)); };
    row.shown_value = [target, scientific, name = row.spelling] {
        return name + " " + shown_real(*target, scientific);
    };
    return row;
}

/// Three numbers behind a pointer to anything that has operator[].
template <class Triple>
OptionRow triple_row(std::string spelling, Triple* target, std::string names, std::string help,
                     bool scientific) {
    OptionRow row{.spelling = std::move(spelling), .pattern = "fff", .help = std::move(help)};
    row.arguments = std::move(names);
    row.apply = [target](const OptionValues& given) {
        for (int i = 0; i < 3; ++i) (*target)[i] = given.real(i);
    };
    row.shown_value = [target, scientific, name = row.spelling] {
        std::string text = name;
        for (int i = 0; i < 3; ++i) text += " " + shown_real((*target)[i], scientific);
        return text;
    };
    return row;
}

}  // namespace

OptionRow& OptionRow::shown(std::function<std::string()> value) {
    shown_value = std::move(value);
    return *this;
}

OptionRow& OptionRow::remark(std::function<std::string()> text) {
    shown_help = std::move(text);
    return *this;
}

OptionRow& OptionRow::unlisted() { return shown({}); }

OptionRow& OptionRow::named(std::string names) {
    arguments = std::move(names);
    return *this;
}

OptionRow& OptionRow::optional_after(std::size_t count) {
    required = count;
    return *this;
}

OptionRow& OptionRow::at_least(double least) {
    minimum = least;
    return *this;
}

OptionRow& OptionRow::differing(std::string how) {
    differs = std::move(how);
    return *this;
}

OptionRow& OptionRow::ours() {
    is_ours = true;
    return *this;
}

OptionTable::OptionTable(std::string program, std::string usage)
    : program_(std::move(program)), usage_(std::move(usage)) {}

OptionRow& OptionTable::add(OptionRow row) {
    if (row.arguments.empty()) row.arguments = default_argument_names(row.pattern);
    rows_.push_back(std::move(row));
    return rows_.back();
}

OptionRow& OptionTable::real(std::string spelling, double* target, std::string help, bool scientific) {
    return add(real_row(std::move(spelling), target, std::move(help), scientific));
}

OptionRow& OptionTable::real(std::string spelling, float* target, std::string help, bool scientific) {
    return add(real_row(std::move(spelling), target, std::move(help), scientific));
}

OptionRow& OptionTable::integer(std::string spelling, int* target, std::string help) {
    OptionRow row{.spelling = std::move(spelling), .pattern = "i", .help = std::move(help)};
    row.apply = [target](const OptionValues& given) { *target = given.integer(0); };
    row.shown_value = [target, name = row.spelling] { return formatted("%s %-9d", name.c_str(), *target); };
    return add(std::move(row));
}

OptionRow& OptionTable::toggle(std::string spelling, bool* target, std::string help) {
    return toggle(std::move(spelling), target, help + " on", help + " off");
}

OptionRow& OptionTable::toggle(std::string spelling, bool* target, std::string help_on,
                               std::string help_off) {
    OptionRow row{.spelling = std::move(spelling), .form = OptionRow::Form::toggle, .help = help_on};
    row.apply = [target](const OptionValues& given) {
        *target = given.attached.empty() ? !*target : given.attached == "+" || given.attached == "1";
    };
    row.shown_value = [target, name = row.spelling] { return name + (*target ? "+" : "-"); };
    row.shown_help = [target, help_on, help_off] { return *target ? help_on : help_off; };
    return add(std::move(row));
}

OptionRow& OptionTable::text(std::string spelling, std::string* target, std::string help) {
    return custom(
        std::move(spelling), "s", [target](const OptionValues& given) { *target = given.text(0); },
        std::move(help));
}

OptionRow& OptionTable::vec3(std::string spelling, Vec3* target, std::string help) {
    return add(triple_row(std::move(spelling), target, "x y z", std::move(help), false));
}

OptionRow& OptionTable::color(std::string spelling, std::array<float, 3>* target, std::string help,
                              bool scientific) {
    return add(triple_row(std::move(spelling), target, "red green blue", std::move(help), scientific));
}

OptionRow& OptionTable::custom(std::string spelling, std::string pattern,
                               std::function<void(const OptionValues&)> apply, std::string help) {
    return add({.spelling = std::move(spelling),
                .pattern = std::move(pattern),
                .help = std::move(help),
                .apply = std::move(apply)});
}

OptionRow& OptionTable::attached(std::string spelling, std::string pattern,
                                 std::function<void(const OptionValues&)> apply, std::string help) {
    OptionRow& row = custom(std::move(spelling), std::move(pattern), std::move(apply), std::move(help));
    row.form = OptionRow::Form::attached;
    return row;
}

OptionRow& OptionTable::rest(std::string spelling, std::size_t least,
                             std::function<void(const OptionValues&)> apply, std::string help) {
    OptionRow& row = custom(std::move(spelling), std::string(least, 's'), std::move(apply), std::move(help));
    row.form = OptionRow::Form::rest;
    return row;
}

OptionRow& OptionTable::unsupported(std::string spelling, std::string pattern, std::string reason) {
    OptionRow& row = custom(std::move(spelling), std::move(pattern), {}, {});
    row.unsupported = std::move(reason);
    return row;
}

void OptionTable::describe(std::string description) { description_ = std::move(description); }

void OptionTable::take_words_literally() { literal_ = true; }

void OptionTable::read_environment(std::string variable) { environment_ = std::move(variable); }

std::string OptionTable::defaults() const {
    std::string text;
    for (const OptionRow& row : rows_) {
        if (!row.shown_value) continue;
        const std::string value = row.shown_value();
        if (value.empty()) continue;
        const std::size_t missing = value.size() < remark_column ? remark_column - value.size() : 1;
        text += value + std::string((missing + 7) / 8, '\t') + "# ";
        text += (row.shown_help ? row.shown_help() : row.help) + "\n";
    }
    return text;
}

std::string OptionTable::help() const {
    std::string text = std::string(version_string()) + "\nusage: " + program_ + " [options]";
    if (!usage_.empty()) text += " " + usage_;
    text += "\n\n";
    if (!description_.empty()) text += description_ + "\n\n";
    const auto add_line = [&text](std::string line, const std::string& remark) {
        line = "  " + line;
        line.resize(std::max(line.size() + 2, help_column), ' ');
        text += line + remark + "\n";
    };
    for (const OptionRow& row : rows_) {
        if (!row.unsupported.empty()) continue;
        std::string line = row.spelling;
        if (row.form == OptionRow::Form::toggle) line += "[+|-]";
        if (row.form == OptionRow::Form::attached) line += "...";
        if (!row.arguments.empty()) line += " " + row.arguments;
        std::string remark = row.help;
        if (row.shown_value) {
            const auto words = split_words(row.shown_value());
            std::string value;
            for (const std::string& word : words) value += (value.empty() ? "" : " ") + word;
            if (!value.empty()) remark += " [" + value + "]";
        }
        add_line(line, remark);
    }
    add_line("-defaults", "print the values in force and exit");
    add_line("-help", "print this list and exit");
    add_line("-version", "print the version and exit");
    if (!literal_) {
        add_line("@file", "read options from a file");
        add_line("$NAME", "read options from an environment variable");
    }

    std::string heading = "\nnot supported yet:\n";
    for (const OptionRow& row : rows_) {
        if (row.unsupported.empty()) continue;
        text += heading;
        heading.clear();
        add_line(row.spelling, row.unsupported);
    }
    return text;
}

}  // namespace infra
